--  SPDX-License-Identifier: Apache-2.0

package body Devices.Processor_Memories with SPARK_Mode is

   procedure Read_ROM (Where : Byte_Address; Data : out Long) is
   begin
      Read_ROM (Board, Where, Data);
   end Read_ROM;

   procedure Read_RAM (Where : Word_Address; Data : out Word) is
   begin
      Read_RAM (Board, Where, Data);
   end Read_RAM;

   procedure Write_RAM (Where : Word_Address; Data : Word) is
   begin
      Write_RAM (Board, Where, Data);
   end Write_RAM;

end Devices.Processor_Memories;
