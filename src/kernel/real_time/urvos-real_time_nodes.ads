--  SPDX-License-Identifier: Apache-2.0

--  A node in real time (report, sections 2.2, 2.3 and 3.1 to 3.3; FRM-1,
--  FRM-4, KRN-1 to KRN-6, EXT-4, D-9): what URVOS.Virtual_Nodes is, on the
--  machine's clock. Each of its processors is an Ada task, named here for
--  Ravenscar; those that the node does not have are never switched on.

with Ada.Real_Time;      use Ada.Real_Time;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Lists;
with URVOS.Task_Trees;   use URVOS.Task_Trees;
with URVOS.Usual_Frames;

generic
   with package Tasks is new URVOS.Task_Lists (<>);

   --  A task's next step, its initialisation if it is its first run, and
   --  the call that it ends with.
   with procedure Run_Step
     (Who       : Tasks.Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   --  Phases 1 and 2 of a start. They end in the application's START call,
   --  unless the self-test has failed.
   with procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

   --  The time is now Now: for whoever stamps what happens.
   with procedure Tell_Time (Now : Clock_Tick);

   --  A task was released late, or ran into its next release (FRM-4).
   with procedure Report_Overrun (Who : Task_Id);

   --  The master's clock has ticked so long after it should have.
   with procedure Observe_Tick (Late : Time_Span);

   --  The clock has ticked so often since it last looked: what is requested of
   --  the present frame (FRM-6).
   with procedure Look_At_Frame
     (Ticks   : Tick_Count;
      Request : out Frame_Request)
   is URVOS.Usual_Frames;
package URVOS.Real_Time_Nodes
  with
    SPARK_Mode,
    Abstract_State =>
      ((Processors with Synchronous, External), Task_Management),
    Initializes    => (Processors, Task_Management)
is

   --  Power up: the clock begins to tick, with tick 0 at this time.
   procedure Switch_On
     (Number   : Processor_Number;
      At_Time  : Time;
      Schedule : Schedule_Name := Report)
   with Global => (In_Out => Processors);

   --  A reset or an exception: the node starts again when the tasks that
   --  now run have ended their steps, at the next tick after that. Of
   --  several requests the last one counts.
   procedure Request_Start (Condition : Start_Condition)
   with Global => (In_Out => Processors);

   --  For whoever watches over the node

   procedure Inspect_Overruns (Number : out Count)
   with Global => (Input => Processors);

   procedure Inspect_Clock (Now : out Clock_Tick)
   with Global => (Input => Processors);

   --  When tick 0 was, as the present frame has it: see URVOS.Shared_Nodes.
   procedure Inspect_Beginning (At_Time : out Time)
   with Global => (Input => Processors);

end URVOS.Real_Time_Nodes;
