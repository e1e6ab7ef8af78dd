--  SPDX-License-Identifier: Apache-2.0

--  A node in real time (report, sections 2.2, 2.3 and 3.1 to 3.3; FRM-1,
--  FRM-4, KRN-1 to KRN-6, EXT-4, D-9): what URVOS.Virtual_Nodes is, on the
--  machine's clock. Each of its processors is an Ada task, named here for
--  Ravenscar; those that the node does not have are never switched on.

with Ada.Real_Time;      use Ada.Real_Time;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Node_Software;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

generic
   with package Software is new URVOS.Node_Software (<>);

   --  The master's clock has ticked this late.
   with procedure Observe_Tick (Late : Time_Span);
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
