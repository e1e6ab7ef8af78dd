--  SPDX-License-Identifier: Apache-2.0

--  The processor board's own ROM and RAM. Addresses select bytes of the ROM,
--  which is read by longs, and words of the RAM (TST-1).
--
--  The memories are outside the flight software. The body leads to them: on a
--  host to simulated memories (Host.Memory_Hardware), on a target to the
--  addresses, by a body of its own. One program on a host may hold several
--  processor boards, each with its own memories.
--
--  This is a boundary of the proof. The proof knows nothing of the values
--  read, and assumes that each bus cycle ends.

with Devices.Memory_Sizes;
with URVOS;          use URVOS;
with URVOS.Memories; use URVOS.Memories;

package Devices.Memory_Bus
  with
    SPARK_Mode,
    Elaborate_Body,
    Abstract_State =>
      (Cells with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Cells
is

   type Board_Number is range 1 .. 4;

   Last_ROM_Long : constant Long_Address := Memory_Sizes.Last_ROM_Long;
   Last_RAM_Word : constant Word_Address := Memory_Sizes.Last_RAM_Word;

   ROM_Longs_Per_Frame : constant := Memory_Sizes.ROM_Longs_Per_Frame;

   --  The address of the ROM's last long.
   Last_ROM_Place : constant Byte_Address := Byte_Of (Last_ROM_Long);

   --  An MC68000 would trap an odd address.
   procedure Read_ROM
     (Board : Board_Number;
      Where : Byte_Address;
      Data  : out Long)
   with
     Inline,
     Global => (Input => Cells),
     Pre    => Where <= Last_ROM_Place and then Where mod Bytes_Per_Long = 0;

   procedure Read_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : out Word)
   with
     Inline,
     Global => (Input => Cells),
     Pre    => Where <= Last_RAM_Word;

   procedure Write_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : Word)
   with
     Inline,
     Global => (In_Out => Cells),
     Pre    => Where <= Last_RAM_Word;

end Devices.Memory_Bus;
