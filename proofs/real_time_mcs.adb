--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time; use Ada.Real_Time;
with MCS;
with URVOS.Real_Time_Nodes;

package body Real_Time_MCS with SPARK_Mode is

   procedure Observe_Tick (Late : Time_Span) is null;

   package Partition is new URVOS.Real_Time_Nodes
     (MCS.Software, Observe_Tick);

   procedure Switch_On (Processors : Processor_Number) is
      Now : constant Time := Clock;
   begin
      Partition.Switch_On (Processors, Now);
   end Switch_On;

end Real_Time_MCS;
