--  SPDX-License-Identifier: Apache-2.0

--  The thermostat on the machine's clock.

with Ada.Real_Time; use Ada.Real_Time;
with URVOS.Real_Time_Nodes;

package Thermostat.Real_Time with SPARK_Mode is

   procedure Observe_Tick (Late : Time_Span) is null;

   package Node is new URVOS.Real_Time_Nodes (Software, Observe_Tick);

end Thermostat.Real_Time;
