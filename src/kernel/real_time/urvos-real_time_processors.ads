--  SPDX-License-Identifier: Apache-2.0

--  One processor of a node in real time, as an Ada task (report, sections
--  2.2, 2.3 and 3.1 to 3.3; FRM-1, FRM-4, KRN-1 to KRN-6, D-9, D-23).
--
--  At each tick of 2 ms the due tasks become ready. Between two ticks they
--  run, step by step, and none preempts another. A tick that comes late by
--  whole ticks keeps its own number, so the true lateness shows.

with Ada.Real_Time;      use Ada.Real_Time;
with URVOS.Node_Software;
with URVOS.Shared_Nodes; use URVOS.Shared_Nodes;
with URVOS.Start_Orders; use URVOS.Start_Orders;

generic
   Self      : Seat;
   This_Node : in out Node;

   --  As in URVOS.Real_Time_Nodes.
   with package Software is new URVOS.Node_Software (<>);
   with procedure Observe_Tick (Late : Time_Span);
package URVOS.Real_Time_Processors
  with
    SPARK_Mode,
    Abstract_State => ((Power with Synchronous, External), Task_Management),
    Initializes    => (Power, Task_Management)
is

   --  The processor's clock begins to tick, with the node's tick 0.
   procedure Switch_On
   with Global => (In_Out => Power);

end URVOS.Real_Time_Processors;
