--  SPDX-License-Identifier: Apache-2.0

--  The monitor's memory of the surfaces from frame to frame, and the health
--  with which the servos' words are made (EXT-6).

pragma SPARK_Mode;

with URVOS.Shared_Data;
with URV.Allocation;
with URV.Surface_Monitor;

package URV.Shared_Surfaces is

   package Monitors is new URVOS.Shared_Data
     (URV.Surface_Monitor.Monitor, Initial => (others => <>));

   package Healths is new URVOS.Shared_Data
     (URV.Allocation.Health, Initial => (others => <>));

end URV.Shared_Surfaces;
