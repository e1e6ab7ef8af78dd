--  SPDX-License-Identifier: Apache-2.0

package body Bare_Memories is

   ROM : array (Byte_Address range 0 .. Last_ROM_Byte) of Byte
   with Volatile_Components, Import, External_Name => "urv_rom_image";

   RAM : array (Word_Address range 0 .. Last_RAM_Word) of Word
   with Volatile_Components, Import, External_Name => "urv_tested_ram";

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

end Bare_Memories;
