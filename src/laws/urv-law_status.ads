--  SPDX-License-Identifier: Apache-2.0

--  The control laws' report to the ground (EXT-3, EXT-5). It is sent like the
--  log, a byte a downlink (SAF-7), and appears in the ground's CORE memory, in
--  the last row of the aircraft's log.

with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URV.Configurations;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Laws;          use URV.Laws;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.Sensor_Checks; use URV.Sensor_Checks;

package URV.Law_Status with Pure, SPARK_Mode is

   --  The words of the report.
   --
   --  Active: the modes, lateral, vertical, power, each in four bits
   --  from the lowest, then the link's state; places in their lists, from 0.
   --  Invalid_Low: invalid sensors, the first 16 of the downlink, the first in
   --  bit 0. Invalid_High: the other sensors.
   --  Silent: the link's silent frames, at most 65535.
   --  Failed: failed surfaces, in the order of URV.Surfaces, the first in
   --  bit 0; the throttle in bit 10.
   --  Age: major frames since the node's cold start, divided by 16, modulo
   --  65536 (GND-45).
   --  Configuration: the serial number of the configuration that was taken
   --  last, above four bits with its table of gains (EXT-2); 0 for none.
   type Report_Item is
     (Active, Invalid_Low, Invalid_High, Silent, Failed, Age, Configuration);
   type Report is array (Report_Item) of Word;

   --  Its row in the log, and the report in that row.

   Row_Number : constant Log_Row_Number := Log_Row_Number'Last;

   function To_Row (Item : Report) return Log_Row is
     (Occurrences_High => Item (Active),
      Occurrences_Low  => Item (Invalid_Low),
      First_Frame_High => Item (Invalid_High),
      First_Frame_Low  => Item (Silent),
      Last_Frame_High  => Item (Failed),
      Last_Frame_Low   => Item (Age),
      Last_Detail      => Item (Configuration))
   with Global => null;

   function From_Row (Row : Log_Row) return Report is
     (Active        => Row (Occurrences_High),
      Invalid_Low   => Row (Occurrences_Low),
      Invalid_High  => Row (First_Frame_High),
      Silent        => Row (First_Frame_Low),
      Failed        => Row (Last_Frame_High),
      Age           => Row (Last_Frame_Low),
      Configuration => Row (Last_Detail))
   with
     Global => null,
     Post   => To_Row (From_Row'Result) = Row;

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

   --  The report without the age.
   function Report_Of
     (Flown    : Laws.Memory;
      Failures : Word;
      Set      : Configurations.Setting) return Report
   is
     (Active        => Mode_Word (Flown),
      Invalid_Low   => Invalid_Bits (Flown.Checks, 0),
      Invalid_High  => Invalid_Bits (Flown.Checks, 1),
      Silent        => Silent_Word (Flown),
      Failed        => Failures,
      Age           => 0,
      Configuration => Configurations.Reported (Set))
   with Global => null;

   function With_Age (Item : Report; Now : Clock_Tick) return Report is
     ((Item with delta Age => Age_Word (Now)))
   with Global => null;

end URV.Law_Status;
