--  A scheduler whose operations exclude each other: what
--  URVOS.Shared_Schedulers consists of (report, sections 2.3 and 3.3; FRM-4,
--  KRN-1 to KRN-3, KRN-6).
--
--  It is a type so that it is proved once, not for each node.

with URVOS.Frames;     use URVOS.Frames;
with URVOS.Schedulers; use URVOS.Schedulers;
with URVOS.Starts;     use URVOS.Starts;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package URVOS.Guarded_Schedulers with SPARK_Mode is

   --  What is wished for by a reset or an exception.
   type Wish is record
      Is_There  : Boolean := False;
      Condition : Start_Condition := Cold_Start;
   end record;

   --  What the scheduler asks its caller to do: resume the next task, report
   --  who has overrun; No_Task is nobody.
   type Orders is record
      Next      : Task_Id := No_Task;
      Late      : Task_Id := No_Task;
      Late_Next : Boolean := False;
   end record;

   subtype Sound_Scheduler is Scheduler
   with Predicate => Is_Sound (Sound_Scheduler);

   --  See URVOS.Shared_Schedulers.
   protected type Guarded_Scheduler is

      procedure Start
        (Tree : Task_Tree;
         Now  : Clock_Tick;
         Todo : out Orders);

      procedure Wake
        (Now     : Clock_Tick;
         Todo    : out Orders;
         Granted : out Wish);

      procedure Request (Condition : Start_Condition);

      procedure Begin_Step (First_Run : out Boolean);

      procedure End_Step
        (Offset : Minor_Frame;
         Failed : Boolean;
         Todo   : out Orders);

      function Overruns return Count;

      function Now return Clock_Tick;

   private
      Tasks  : Sound_Scheduler := Empty_Scheduler (0);
      Wanted : Wish;

      --  Overruns before the last start.
      Former : Count := 0;
   end Guarded_Scheduler;

end URVOS.Guarded_Schedulers;
