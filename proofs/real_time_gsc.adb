--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time; use Ada.Real_Time;
with GSC;
with URVOS.Real_Time_Nodes;

package body Real_Time_GSC with SPARK_Mode is

   procedure Observe_Tick (Late : Time_Span) is null;

   package Partition is new URVOS.Real_Time_Nodes
     (GSC.Software, Observe_Tick);

   procedure Switch_On (Processors : Processor_Number) is
      Now : constant Time := Clock;
   begin
      Partition.Switch_On (Processors, Now);
   end Switch_On;

end Real_Time_GSC;
