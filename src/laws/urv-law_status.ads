--  SPDX-License-Identifier: Apache-2.0

--  What the ground is told of the control laws (EXT-3, EXT-5): a row of the
--  aircraft's log that is not an error's. It goes down as the log does, a
--  byte a downlink (SAF-7), and stands in the ground's CORE memory.
--
--  word 1  what flies: lateral, vertical, power, each in four bits from the
--          lowest, then the link's state; places in their lists, from 0
--  word 2  sensors that are not valid, the first 16 of the downlink, the
--          first in bit 0
--  word 3  the other sensors
--  word 4  how many silent frames the link has had, at most 65535
--
--  word 5  surfaces that have failed, in the order of URV.Surfaces, the first
--          in bit 0; the throttle in bit 10
--
--  word 7  the serial number of the configuration that was taken last, above
--          four bits with its table of gains (EXT-2); 0 for none
--
--  The other word is 0.

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS;               use URVOS;
with URV.Configurations;
with URV.Laws;            use URV.Laws;
with URV.Link_Loss;       use URV.Link_Loss;
with URV.Sensor_Checks;   use URV.Sensor_Checks;

package URV.Law_Status with Pure, SPARK_Mode is

   Row_Number : constant Log_Row_Number := Log_Row_Number'Last;

   function Mode_Word (Item : Laws.Memory) return Word is
     (Lateral_Mode'Pos (Item.Flown.Lateral)
      + 16 * Vertical_Mode'Pos (Item.Flown.Vertical)
      + 256 * Power_Mode'Pos (Item.Flown.Power)
      + 4_096 * Link_State'Pos (Item.Link.State))
   with Global => null;

   function Silent_Word (Item : Laws.Memory) return Word is
     (if Item.Link.Silent > Frame_Count (Word'Last) then Word'Last
      else Word (Item.Link.Silent))
   with Global => null;

   function To_Row
     (Item   : Laws.Memory;
      Failed : Word;
      Now    : Configurations.Setting) return Log_Row
   is
     (Occurrences_High => Mode_Word (Item),
      Occurrences_Low  => Invalid_Bits (Item.Checks, 0),
      First_Frame_High => Invalid_Bits (Item.Checks, 1),
      First_Frame_Low  => Silent_Word (Item),
      Last_Frame_High  => Failed,
      Last_Detail      => Configurations.Told (Now),
      others           => 0)
   with Global => null;

end URV.Law_Status;
