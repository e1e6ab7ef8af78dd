--  SPDX-License-Identifier: Apache-2.0

--  The processor board's ROM and RAM, at the addresses that the linker's
--  image.ld gives (TST-1, BRD-3). A machine has one board.

package body Devices.Memory_Bus with SPARK_Mode => Off is

   ROM : array (Byte_Address range 0 .. Last_ROM_Byte) of Byte
   with Volatile, Import, External_Name => "urv_rom_image";

   RAM : array (Word_Address range 0 .. Last_RAM_Word) of Word
   with Volatile, Import, External_Name => "urv_tested_ram";

   procedure Read_ROM
     (Board : Board_Number;
      Where : Byte_Address;
      Data  : out Byte)
   is
      pragma Unreferenced (Board);
   begin
      Data := ROM (Where);
   end Read_ROM;

   procedure Read_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : out Word)
   is
      pragma Unreferenced (Board);
   begin
      Data := RAM (Where);
   end Read_RAM;

   procedure Write_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : Word)
   is
      pragma Unreferenced (Board);
   begin
      RAM (Where) := Data;
   end Write_RAM;

end Devices.Memory_Bus;
