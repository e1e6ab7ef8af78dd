--  SPDX-License-Identifier: Apache-2.0

--  The surfaces' health, with which PWM makes the servos' words (EXT-6).

pragma SPARK_Mode;

with URVOS.Shared_Data;
with URV.Allocation;

package URV.Shared_Surfaces is

   package Healths is new URVOS.Shared_Data
     (URV.Allocation.Health, Initial => (others => <>));

end URV.Shared_Surfaces;
