--  SPDX-License-Identifier: Apache-2.0

--  The gains of the surfaces that replace a failed one (EXT-6), computed from
--  the aircraft's moments. scripts/laws/allocation.py writes this file; do not
--  edit it.

with URV.Law_Units; use URV.Law_Units;
with URV.Surfaces;  use URV.Surfaces;

package URV.Allocation_Table with Pure, SPARK_Mode is

   --  A gain of 1.
   Unit : constant := 1024;

   subtype Gain is Number range -4_096 .. 4_096;

   type Gain_Row is array (Surface) of Gain;
   type Gain_Table is array (Surface) of Gain_Row;

   --  Words of each surface that replace one word of the failed surface.
   Gains : constant Gain_Table :=
     (
      Left_Aileron =>
        (Left_Aileron => 0,
         Right_Aileron => 970,
         Left_Elevator => 162,
         Right_Elevator => -162,
         Left_Rudder => -2,
         Right_Rudder => -2,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0),
      Right_Aileron =>
        (Left_Aileron => 970,
         Right_Aileron => 0,
         Left_Elevator => 162,
         Right_Elevator => -162,
         Left_Rudder => -2,
         Right_Rudder => -2,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0),
      Left_Elevator =>
        (Left_Aileron => 171,
         Right_Aileron => 171,
         Left_Elevator => 0,
         Right_Elevator => 1024,
         Left_Rudder => 12,
         Right_Rudder => 12,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0),
      Right_Elevator =>
        (Left_Aileron => -171,
         Right_Aileron => -171,
         Left_Elevator => 1024,
         Right_Elevator => 0,
         Left_Rudder => -12,
         Right_Rudder => -12,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0),
      Left_Rudder =>
        (Left_Aileron => -2,
         Right_Aileron => -2,
         Left_Elevator => 11,
         Right_Elevator => -11,
         Left_Rudder => 0,
         Right_Rudder => 1024,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0),
      Right_Rudder =>
        (Left_Aileron => -2,
         Right_Aileron => -2,
         Left_Elevator => 11,
         Right_Elevator => -11,
         Left_Rudder => 1024,
         Right_Rudder => 0,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0),
      Left_Flap_1 =>
        (Left_Aileron => 176,
         Right_Aileron => 176,
         Left_Elevator => 13,
         Right_Elevator => -46,
         Left_Rudder => 12,
         Right_Rudder => 12,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0),
      Right_Flap_1 =>
        (Left_Aileron => -176,
         Right_Aileron => -176,
         Left_Elevator => -46,
         Right_Elevator => 13,
         Left_Rudder => -12,
         Right_Rudder => -12,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0),
      Left_Flap_2 =>
        (Left_Aileron => 117,
         Right_Aileron => 117,
         Left_Elevator => 9,
         Right_Elevator => -31,
         Left_Rudder => 8,
         Right_Rudder => 8,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0),
      Right_Flap_2 =>
        (Left_Aileron => -117,
         Right_Aileron => -117,
         Left_Elevator => -31,
         Right_Elevator => 9,
         Left_Rudder => -8,
         Right_Rudder => -8,
         Left_Flap_1 => 0,
         Right_Flap_1 => 0,
         Left_Flap_2 => 0,
         Right_Flap_2 => 0));

   --  Words of an aileron with the rolling moment of one word of the flap.
   type Flap_Row is array (Flap) of Number range -1_024 .. 1_024;

   Roll_Of_Flap : constant Flap_Row :=
     (
      Left_Flap_1 => 360,
      Right_Flap_1 => -360,
      Left_Flap_2 => 240,
      Right_Flap_2 => -240);

   --  Words of both flaps of a side with the rolling moment of one word of
   --  the aileron.
   Flap_For_Roll : constant := 1747;

end URV.Allocation_Table;
