--  SPDX-License-Identifier: Apache-2.0

--  The processor board's ROM and RAM for Devices.Memory_Bus. The linker's
--  image.ld gives their addresses (TST-1, BRD-3).

with Devices.Memory_Bus; use Devices.Memory_Bus;
with URVOS;              use URVOS;
with URVOS.Memories;     use URVOS.Memories;

package Bare_Memories is

   procedure Read_ROM
     (Board : Board_Number;
      Where : Byte_Address;
      Data  : out Byte)
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

end Bare_Memories;
