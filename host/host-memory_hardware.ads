--  SPDX-License-Identifier: Apache-2.0

--  The memories of the processor boards, used by Devices.Memory_Bus, with
--  faults to plant (SIM-1, TST-1, TST-3).
--
--  The ROM holds an image made from numbers (D-44), with its sum in its last
--  eight bytes. The RAM is an array of cells, one per bit. Both are healthy
--  until a fault is planted.

with Devices.Memory_Bus; use Devices.Memory_Bus;
with URVOS.Memories;     use URVOS.Memories;

package Host.Memory_Hardware is

   --  The bytes of the ROM. The first of four is the high one of a long.
   subtype ROM_Address is Byte_Address
     range 0 .. Bytes_Per_Long * Byte_Address (Last_ROM_Long) + 3;
   subtype RAM_Address is Word_Address range 0 .. Last_RAM_Word;

   type Bit_Number is range 0 .. 15;

   --  The bytes of the image as they were programmed.
   function Programmed (Where : ROM_Address) return Byte;

   --  Changes some bits of a byte of the ROM.
   procedure Spoil_ROM
     (Board : Board_Number;
      Where : ROM_Address;
      Flips : Byte);

   --  Makes the whole ROM read as one value: erased, or missing.
   procedure Blank_ROM (Board : Board_Number; Data : Byte);

   --  Nothing answers the next read of the ROM: it raises an exception in the
   --  processor that reads.
   procedure Fail_Next_Read (Board : Board_Number);

   Bus_Error : exception;

   --  Some bits of a word of the RAM read as 0 from now on.
   procedure Stick_RAM
     (Board : Board_Number;
      Where : RAM_Address;
      Bits  : Word);

   --  The effect of a fault in the RAM. Cell is the bit that suffers; Source
   --  is another bit, which causes it.
   type Fault_Kind is
     (None,
      Stuck,             --  Cell is always Value
      No_Transition,     --  Cell does not become Value from the other
      Inversion,         --  Source becomes Edge: Cell is inverted
      Idempotent,        --  Source becomes Edge: Cell becomes Value
      State_Coupling,    --  while Source is Edge, Cell is Value
      No_Cells,          --  Cell's word is not reached, reads give Value
      Other_Cells,       --  Cell's word reaches Source's instead
      Both_Cells);       --  Cell's word reaches Source's too, and reads as
                         --  the wired combination: "and" when Value is
                         --  0, "or" when it is 1

   type Bit_Value is range 0 .. 1;

   type Bit_Place is record
      Where : RAM_Address := 0;
      Bit   : Bit_Number  := 0;
   end record;

   type Fault is record
      Kind   : Fault_Kind := None;
      Cell   : Bit_Place;
      Source : Bit_Place;
      Edge   : Bit_Value  := 1;
      Value  : Bit_Value  := 0;
   end record;

   --  Up to two at once, so that one may hide the other.
   type Fault_Number is range 1 .. 2;

   procedure Plant
     (Board   : Board_Number;
      Planted : Fault;
      Number  : Fault_Number := 1);

   --  Removes all faults of the board. The contents of its RAM stay.
   procedure Repair (Board : Board_Number);

private

   procedure Read_ROM
     (Board : Board_Number;
      Where : Byte_Address;
      Data  : out Long)
   with Export, Convention => Ada, External_Name => "urv_read_rom";

   procedure Read_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : out Word)
   with Export, Convention => Ada, External_Name => "urv_read_ram";

   procedure Write_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : Word)
   with Export, Convention => Ada, External_Name => "urv_write_ram";

end Host.Memory_Hardware;
