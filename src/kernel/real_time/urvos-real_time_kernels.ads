--  Task management in real time (report, sections 2.2, 2.3 and 3.1 to 3.3;
--  FRM-1, FRM-4, KRN-1 to KRN-3, KRN-6, INI-1, INI-2, D-9).
--
--  Each task of the tree is an Ada task that waits for its turn. Which one
--  has it URVOS.Shared_Schedulers decides; Resume then lets that Ada task go
--  on. Nobody else is resumed before it has ended its step, so no task of
--  the node preempts another.
--
--  A clock of the kernel's own ticks every 2 ms. A tick that comes late by
--  whole ticks is the tick that it should have been, so that lateness is
--  seen as what it is.

with Ada.Real_Time;            use Ada.Real_Time;
with URVOS.Frames;             use URVOS.Frames;
with URVOS.Guarded_Schedulers; use URVOS.Guarded_Schedulers;
with URVOS.Starts;             use URVOS.Starts;
with URVOS.Task_Trees;         use URVOS.Task_Trees;

generic
   --  The node's tasks: see URVOS.Shared_Schedulers.

   with procedure Start_Tasks
     (Tree : Task_Tree;
      Now  : Clock_Tick;
      Todo : out Orders);

   with procedure Wake
     (Now     : Clock_Tick;
      Todo    : out Orders;
      Granted : out Wish);

   with procedure Request_Start (Condition : Start_Condition);

   with procedure End_Task_Step
     (Offset : Minor_Frame;
      Failed : Boolean;
      Todo   : out Orders);

   --  Phases 1 and 2 of a start. They end in the application's START call,
   --  unless the self-test has failed.
   with procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

   with function Task_Tree_Of (Now : Clock_Tick) return Task_Tree;

   --  The time is now Now: for whoever stamps what happens.
   with procedure Tell_Time (Now : Clock_Tick);

   --  A task was released late, or ran into its next release (FRM-4).
   with procedure Report_Overrun (Id : Task_Id);

   --  Lets the Ada task go on that runs this task.
   with procedure Resume (Id : Task_Id);

   --  The clock has ticked so long after it should have.
   with procedure Observe_Tick (Late : Time_Span);
package URVOS.Real_Time_Kernels
  with
    SPARK_Mode,
    Abstract_State => (Power_Switch with Synchronous, External),
    Initializes    => Power_Switch
is

   --  Power up: the clock begins to tick, with tick 0.
   procedure Switch_On;

   --  For the Ada task whose turn it is: its step has ended, and the next
   --  task goes on.
   procedure End_Step (Offset : Minor_Frame; Failed : Boolean);

end URVOS.Real_Time_Kernels;
