with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with System;
with URVOS.Schedulers;             use URVOS.Schedulers;

package body URVOS.Real_Time_Kernels
  with
    SPARK_Mode,
    Refined_State =>
      (Task_Management => Guarded,
       Power_Switch    => (Power, Ticker))
is

   subtype Sound_Scheduler is Scheduler
   with Predicate => Is_Sound (Sound_Scheduler);

   --  What is wished for by a reset or an exception.
   type Wish is record
      Is_There  : Boolean := False;
      Condition : Start_Condition := Cold_Start;
   end record;

   --  What the kernel asks its caller to do: resume the next task, report
   --  who has overrun; No_Task is nobody.
   type Orders is record
      Next      : Task_Id := No_Task;
      Late      : Task_Id := No_Task;
      Late_Next : Boolean := False;
   end record;

   --  Two counts together; the last value stands for more.
   function Sum (Left, Right : Count) return Count is
     (if Left > Count'Last - Right then Count'Last else Left + Right)
   with Global => null;

   procedure Follow (Todo : Orders);

   --  Gives an idle processor to the next task.
   procedure Choose (Tasks : in out Scheduler; Todo : in out Orders)
   with
     Global => null,
     Pre    => Is_Sound (Tasks),
     Post   => Is_Sound (Tasks);

   protected Guarded is

      --  The tasks of the tree are loaded.
      procedure Start
        (Tree : Task_Tree;
         Now  : Clock_Tick;
         Todo : out Orders);

      --  Nobody is resumed while a start is wished for and the processor
      --  idle.
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
   end Guarded;

   --  Opened by the power switch.
   Power : Suspension_Object;

   task Ticker with Priority => System.Default_Priority + 1;

   Tick_Time : constant Time_Span := Microseconds (Microseconds_Per_Tick);

   procedure Choose (Tasks : in out Scheduler; Todo : in out Orders) is
      Before : constant Count := Overruns (Tasks);
   begin
      Dispatch (Tasks);
      if not Is_Idle (Tasks) then
         Todo.Next := Id_Of (Tasks, Running_TCB (Tasks));
         Todo.Late_Next := Overruns (Tasks) /= Before;
      end if;
   end Choose;

   protected body Guarded is

      procedure Start
        (Tree : Task_Tree;
         Now  : Clock_Tick;
         Todo : out Orders) is
      begin
         Former := Sum (Former, Overruns (Tasks));
         Start (Tasks, Tree, Now);
         Todo := (others => <>);
         if not Is_Idle (Tasks) then
            Todo.Next := Id_Of (Tasks, Running_TCB (Tasks));
         end if;
      end Start;

      procedure Wake
        (Now     : Clock_Tick;
         Todo    : out Orders;
         Granted : out Wish) is
      begin
         if Now >= Clock (Tasks) then
            Wake (Tasks, Now);
         end if;

         Todo := (others => <>);
         Granted := (Is_There => False, Condition => Cold_Start);
         if Is_Idle (Tasks) then
            if Wanted.Is_There then
               Granted := Wanted;
               Wanted.Is_There := False;
            else
               Choose (Tasks, Todo);
            end if;
         end if;
      end Wake;

      procedure Request (Condition : Start_Condition) is
      begin
         Wanted := (Is_There => True, Condition => Condition);
      end Request;

      procedure Begin_Step (First_Run : out Boolean) is
      begin
         First_Run :=
           not Is_Idle (Tasks)
           and then Is_First_Run (Tasks, Running_TCB (Tasks));
      end Begin_Step;

      procedure End_Step
        (Offset : Minor_Frame;
         Failed : Boolean;
         Todo   : out Orders) is
      begin
         if Failed then
            Wanted := (Is_There => True, Condition => Processor_Restart);
         end if;

         Todo := (others => <>);
         if not Is_Idle (Tasks) then
            if Has_Overrun (Tasks) then
               Todo.Late := Id_Of (Tasks, Running_TCB (Tasks));
            end if;
            Sleep (Tasks, Next_Release (Clock (Tasks), Offset));
            if not Wanted.Is_There then
               Choose (Tasks, Todo);
            end if;
         end if;
      end End_Step;

      function Overruns return Count is
        (Sum (Former, Overruns (Tasks)));

      function Now return Clock_Tick is (Clock (Tasks));

   end Guarded;

   procedure Follow (Todo : Orders) is
   begin
      if Todo.Late /= No_Task then
         Report_Overrun (Todo.Late);
      end if;
      if Todo.Next /= No_Task then
         if Todo.Late_Next then
            Report_Overrun (Todo.Next);
         end if;
         Resume (Todo.Next);
      end if;
   end Follow;

   task body Ticker is

      --  So many missed ticks are made up for at once.
      Most_Missed : constant := 100;

      Next_Tick : Time;
      Now       : Clock_Tick := 0;
      Woken_At  : Time;

      --  A self-test takes longer than a tick: the tasks are loaded at the
      --  tick that comes after it.
      Is_Starting : Boolean := False;
      Passed      : Boolean := False;

      Granted   : Wish;
      Todo      : Orders;
   begin
      Suspend_Until_True (Power);
      Next_Tick := Clock;
      loop
         Tell_Time (Now);
         if Is_Starting then
            Guarded.Start
              ((if Passed then Task_Tree_Of (Now) else Empty_Tree),
               Now,
               Todo);
            Is_Starting := False;
         else
            Guarded.Wake (Now, Todo, Granted);
            if Granted.Is_There then
               Begin_Again (Granted.Condition, Now, Passed);
               Is_Starting := True;
            end if;
         end if;
         Follow (Todo);

         Next_Tick := Next_Tick + Tick_Time;
         delay until Next_Tick;
         Woken_At := Clock;
         if not Is_Starting then
            Observe_Tick (Woken_At - Next_Tick);
         end if;
         Now := Advanced (Now);
         for Missed in 1 .. Most_Missed loop
            exit when Next_Tick + Tick_Time > Woken_At;
            Next_Tick := Next_Tick + Tick_Time;
            Now := Advanced (Now);
         end loop;
      end loop;
   end Ticker;

   procedure Switch_On is
   begin
      Guarded.Request (Cold_Start);
      Set_True (Power);
   end Switch_On;

   procedure Request_Start (Condition : Start_Condition) is
   begin
      Guarded.Request (Condition);
   end Request_Start;

   procedure Begin_Step (First_Run : out Boolean) is
   begin
      Guarded.Begin_Step (First_Run);
   end Begin_Step;

   procedure End_Step (Offset : Minor_Frame; Failed : Boolean) is
      Todo : Orders;
   begin
      Guarded.End_Step (Offset, Failed, Todo);
      Follow (Todo);
   end End_Step;

   procedure Inspect_Overruns (Number : out Count) is
   begin
      Number := Guarded.Overruns;
   end Inspect_Overruns;

   procedure Inspect_Clock (Now : out Clock_Tick) is
   begin
      Now := Guarded.Now;
   end Inspect_Clock;

end URVOS.Real_Time_Kernels;
