--  SPDX-License-Identifier: Apache-2.0

--  A node in real time (report, sections 2.2, 2.3 and 3.1 to 3.3; FRM-1,
--  FRM-4, KRN-1 to KRN-6, EXT-4, D-9). It does on the machine's clock what
--  URVOS.Virtual_Nodes does in virtual time. Each processor is an Ada task.
--  Ravenscar demands that all four are declared here; the node switches on
--  only those that it has.

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

   --  A reset or an exception. The node starts again at the first tick after
   --  all running tasks have ended their steps. The last of several requests
   --  counts.
   procedure Request_Start (Condition : Start_Condition)
   with Global => (In_Out => Processors);

   --  For monitors of the node

   procedure Inspect_Overruns (Number : out Count)
   with Global => (Input => Processors);

   procedure Inspect_Clock (Now : out Clock_Tick)
   with Global => (Input => Processors);

   --  The time of tick 0 by the present frame; see URVOS.Shared_Nodes.
   procedure Inspect_Beginning (At_Time : out Time)
   with Global => (Input => Processors);

end URVOS.Real_Time_Nodes;
