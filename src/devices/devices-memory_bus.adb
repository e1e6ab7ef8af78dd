--  SPDX-License-Identifier: Apache-2.0

--  This body keeps no copy of the memories. It leads to those of a host; a
--  target has its own body, which reads and writes the address.

package body Devices.Memory_Bus
  with
    SPARK_Mode,
    Refined_State => (Cells => null)
is

   procedure Read_Host_ROM
     (Board : Board_Number; Where : Byte_Address; Data : out Long)
   with
     Import,
     Convention    => Ada,
     External_Name => "urv_read_rom",
     Global        => null;

   procedure Read_Host_RAM
     (Board : Board_Number; Where : Word_Address; Data : out Word)
   with
     Import,
     Convention    => Ada,
     External_Name => "urv_read_ram",
     Global        => null;

   procedure Write_Host_RAM
     (Board : Board_Number; Where : Word_Address; Data : Word)
   with
     Import,
     Convention    => Ada,
     External_Name => "urv_write_ram",
     Global        => null;

   procedure Read_ROM
     (Board : Board_Number; Where : Byte_Address; Data : out Long)
     renames Read_Host_ROM;

   procedure Read_RAM
     (Board : Board_Number; Where : Word_Address; Data : out Word)
     renames Read_Host_RAM;

   procedure Write_RAM
     (Board : Board_Number; Where : Word_Address; Data : Word)
     renames Write_Host_RAM;

end Devices.Memory_Bus;
