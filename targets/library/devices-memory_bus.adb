--  SPDX-License-Identifier: Apache-2.0

--  The processor board's ROM and RAM, at the addresses that the linker's
--  image.ld gives (TST-1, BRD-3). A machine has one board.

with System.Storage_Elements; use System.Storage_Elements;

package body Devices.Memory_Bus with SPARK_Mode => Off is

   --  The first long and the first word. The rest is by address: the compiler
   --  would multiply and check an index at each access.

   ROM : constant Long
   with Import, External_Name => "urv_rom_image";

   RAM : constant Word
   with Import, External_Name => "urv_tested_ram";

   procedure Read_ROM
     (Board : Board_Number;
      Where : Byte_Address;
      Data  : out Long)
   is
      pragma Unreferenced (Board);
      Here : constant Long
      with Import, Address => ROM'Address + Storage_Offset (Where);
   begin
      Data := Here;
   end Read_ROM;

   procedure Read_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : out Word)
   is
      pragma Unreferenced (Board);
      Here : constant Word
      with
        Volatile,
        Import,
        Address => RAM'Address + 2 * Storage_Offset (Where);
   begin
      Data := Here;
   end Read_RAM;

   procedure Write_RAM
     (Board : Board_Number;
      Where : Word_Address;
      Data  : Word)
   is
      pragma Unreferenced (Board);
      Here : Word
      with
        Volatile,
        Import,
        Address => RAM'Address + 2 * Storage_Offset (Where);
   begin
      Here := Data;
   end Write_RAM;

end Devices.Memory_Bus;
