--  SPDX-License-Identifier: Apache-2.0

--  One processor of a node in real time, as an Ada task (report, sections
--  2.2, 2.3 and 3.1 to 3.3; FRM-1, FRM-4, KRN-1 to KRN-6, D-9, D-23).
--
--  At each tick of 2 ms the tasks that are due become ready; between two
--  ticks they run, step by step, and none preempts another. A tick that
--  comes late by whole ticks is the tick that it should have been, so that
--  lateness is seen as what it is.

with Ada.Real_Time;      use Ada.Real_Time;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Shared_Nodes; use URVOS.Shared_Nodes;
with URVOS.Start_Orders; use URVOS.Start_Orders;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Lists;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

generic
   Who       : Seat;
   This_Node : in out Node;

   --  The rest as in URVOS.Real_Time_Nodes.

   with package Tasks is new URVOS.Task_Lists (<>);
   with procedure Run_Step
     (Who       : Tasks.Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);
   with procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);
   with procedure Tell_Time (Now : Clock_Tick);
   with procedure Report_Overrun (Who : Task_Id);
   with procedure Observe_Tick (Late : Time_Span);
   with procedure Look_At_Frame
     (Ticks   : Tick_Count;
      Request : out Frame_Request);
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
