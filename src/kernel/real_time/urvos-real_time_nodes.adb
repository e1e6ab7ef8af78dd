--  SPDX-License-Identifier: Apache-2.0

with URVOS.Real_Time_Processors;
with URVOS.Shared_Nodes;

package body URVOS.Real_Time_Nodes
  with
    SPARK_Mode,
    Refined_State =>
      (Processors      =>
         (This_Node, Processor_1.Power, Processor_2.Power,
          Processor_3.Power, Processor_4.Power),
       Task_Management =>
         (Processor_1.Task_Management, Processor_2.Task_Management,
          Processor_3.Task_Management, Processor_4.Task_Management))
is

   This_Node : URVOS.Shared_Nodes.Node;

   package Processor_1 is new URVOS.Real_Time_Processors
     (1, This_Node, Software, Observe_Tick);

   package Processor_2 is new URVOS.Real_Time_Processors
     (2, This_Node, Software, Observe_Tick);

   package Processor_3 is new URVOS.Real_Time_Processors
     (3, This_Node, Software, Observe_Tick);

   package Processor_4 is new URVOS.Real_Time_Processors
     (4, This_Node, Software, Observe_Tick);

   procedure Switch_On
     (Number   : Processor_Number;
      At_Time  : Time;
      Schedule : Schedule_Name := Report) is
   begin
      This_Node.Switch_On (Number, At_Time, Schedule);
      Processor_1.Switch_On;
      if Number > 1 then
         Processor_2.Switch_On;
      end if;
      if Number > 2 then
         Processor_3.Switch_On;
      end if;
      if Number > 3 then
         Processor_4.Switch_On;
      end if;
   end Switch_On;

   procedure Request_Start (Condition : Start_Condition) is
   begin
      This_Node.Request (Condition);
   end Request_Start;

   procedure Inspect_Overruns (Number : out Count) is
   begin
      Number := This_Node.Overruns;
   end Inspect_Overruns;

   procedure Inspect_Clock (Now : out Clock_Tick) is
   begin
      Now := This_Node.Now;
   end Inspect_Clock;

   procedure Inspect_Beginning (At_Time : out Time) is
   begin
      At_Time := This_Node.Counted_From;
   end Inspect_Beginning;

end URVOS.Real_Time_Nodes;
