--  The tasks of a node that runs in real time, as its Ada tasks share them
--  (report, sections 2.2, 2.3 and 3.1 to 3.3; FRM-4, KRN-1 to KRN-3, KRN-6,
--  D-9).
--
--  Which task has its turn URVOS.Schedulers decides, here in a protected
--  object. What is then to be done the caller does: see
--  URVOS.Real_Time_Kernels.

with URVOS.Frames;             use URVOS.Frames;
with URVOS.Guarded_Schedulers; use URVOS.Guarded_Schedulers;
with URVOS.Starts;             use URVOS.Starts;
with URVOS.Task_Trees;         use URVOS.Task_Trees;

generic
package URVOS.Shared_Schedulers
  with
    SPARK_Mode,
    Abstract_State =>
      (Task_Management with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Task_Management
is

   --  The tasks of the tree are loaded.
   procedure Start
     (Tree : Task_Tree;
      Now  : Clock_Tick;
      Todo : out Orders)
   with
     Global  => (In_Out => Task_Management),
     Depends => ((Task_Management, Todo) => (Task_Management, Tree, Now));

   --  The clock has ticked. Nobody is resumed while a start is wished for
   --  and the processor idle.
   procedure Wake
     (Now     : Clock_Tick;
      Todo    : out Orders;
      Granted : out Wish)
   with
     Global  => (In_Out => Task_Management),
     Depends => ((Task_Management, Todo, Granted) => (Task_Management, Now));

   --  A reset or an exception: the node starts again when the task that now
   --  runs has ended its step, at the next tick after that. Of several
   --  wishes the last one counts.
   procedure Request_Start (Condition : Start_Condition)
   with
     Global  => (In_Out => Task_Management),
     Depends => (Task_Management => (Task_Management, Condition));

   --  For the Ada task whose turn it is

   --  First_Run tells that its task has not run since it was loaded.
   procedure Begin_Step (First_Run : out Boolean)
   with
     Global  => (In_Out => Task_Management),
     Depends => ((Task_Management, First_Run) => Task_Management);

   --  SLEEP: the calling task sleeps until its offset in the next major
   --  frame (FRM-2, FRM-3). A task that Failed brings the node a restart.
   procedure End_Step
     (Offset : Minor_Frame;
      Failed : Boolean;
      Todo   : out Orders)
   with
     Global  => (In_Out => Task_Management),
     Depends => ((Task_Management, Todo) => (Task_Management, Offset, Failed));

   --  For whoever watches over the node

   procedure Inspect_Overruns (Number : out Count)
   with
     Global  => (Input => Task_Management),
     Depends => (Number => Task_Management);

   procedure Inspect_Clock (Now : out Clock_Tick)
   with
     Global  => (Input => Task_Management),
     Depends => (Now => Task_Management);

end URVOS.Shared_Schedulers;
