--  SPDX-License-Identifier: Apache-2.0

--  The control laws' report to the ground (EXT-3, EXT-5): a row of the
--  aircraft's log that belongs to no error. It is sent like the log, a byte a
--  downlink (SAF-7), and appears in the ground's CORE memory.
--
--  word 1  active modes: lateral, vertical, power, each in four bits from the
--          lowest, then the link's state; places in their lists, from 0
--  word 2  invalid sensors, the first 16 of the downlink, the first in bit 0
--  word 3  the other sensors
--  word 4  the link's silent frames, at most 65535
--
--  word 5  failed surfaces, in the order of URV.Surfaces, the first in bit 0;
--          the throttle in bit 10
--
--  word 6  the node's age: major frames since its cold start, divided by 16,
--          modulo 65536 (GND-45)
--
--  word 7  the serial number of the configuration that was taken last, above
--          four bits with its table of gains (EXT-2); 0 for none

with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URV.Configurations;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Laws;          use URV.Laws;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.Sensor_Checks; use URV.Sensor_Checks;

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

   --  The unit of a node's age, 0.32 s.
   Ticks_Per_Age : constant := 16 * Ticks_Per_Major_Frame;

   function Age_Word (Now : Clock_Tick) return Word is
     (Word (Now / Ticks_Per_Age mod 2 ** Word'Size))
   with Global => null;

   --  The row without the age.
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

   function With_Age (Row : Log_Row; Now : Clock_Tick) return Log_Row is
     ((Row with delta Last_Frame_Low => Age_Word (Now)))
   with Global => null;

end URV.Law_Status;
