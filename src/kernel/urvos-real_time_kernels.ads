--  Task management in real time (report, sections 2.2, 2.3 and 3.1 to 3.3;
--  FRM-1, FRM-4, KRN-1 to KRN-3, KRN-6, INI-1, INI-2, D-9).
--
--  Each task of the tree is an Ada task that waits for its turn. Which one
--  has it URVOS.Schedulers decides, here in a protected object; Resume then
--  lets that Ada task go on. Nobody else is resumed before it has ended its
--  step, so no task of the node preempts another.
--
--  A clock of the kernel's own ticks every 2 ms. A tick that comes late by
--  whole ticks is the tick that it should have been, so that lateness is
--  seen as what it is.

with Ada.Real_Time;      use Ada.Real_Time;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

generic
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
    Abstract_State =>
      ((Task_Management with Synchronous,
        External => (Async_Readers, Async_Writers)),
       (Power_Switch with Synchronous, External)),
    Initializes    => (Task_Management, Power_Switch)
is

   --  Power up: the clock begins to tick, with tick 0.
   procedure Switch_On
   with Global => (In_Out => (Task_Management, Power_Switch));

   --  A reset or an exception: the node starts again when the task that now
   --  runs has ended its step, at the next tick after that. Of several
   --  wishes the last one counts.
   procedure Request_Start (Condition : Start_Condition)
   with Global => (In_Out => Task_Management);

   --  For the Ada task whose turn it is

   --  First_Run tells that its task has not run since it was loaded.
   procedure Begin_Step (First_Run : out Boolean)
   with Global => (In_Out => Task_Management);

   --  SLEEP: the calling task sleeps until its offset in the next major
   --  frame (FRM-2, FRM-3), and the next task goes on. A task that Failed
   --  brings the node a restart.
   procedure End_Step (Offset : Minor_Frame; Failed : Boolean);

   --  For whoever watches over the node

   procedure Inspect_Overruns (Number : out Count)
   with Global => (Input => Task_Management);

   procedure Inspect_Clock (Now : out Clock_Tick)
   with Global => (Input => Task_Management);

end URVOS.Real_Time_Kernels;
