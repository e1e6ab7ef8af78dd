--  SPDX-License-Identifier: Apache-2.0

--  The ROM and the RAM of one processor board, for its programs (TST-1, TST-3,
--  D-17).

with Devices.Memory_Bus; use Devices.Memory_Bus;
with URVOS;              use URVOS;
with URVOS.Memories;     use URVOS.Memories;

generic
   Board : Board_Number;
package Devices.Processor_Memories with SPARK_Mode is

   procedure Read_ROM (Where : Byte_Address; Data : out Long)
   with
     Inline,
     Global => (Input => Cells),
     Pre    => Where <= Last_ROM_Place and then Where mod Bytes_Per_Long = 0;

   procedure Read_RAM (Where : Word_Address; Data : out Word)
   with
     Inline,
     Global => (Input => Cells),
     Pre    => Where <= Last_RAM_Word;

   procedure Write_RAM (Where : Word_Address; Data : Word)
   with
     Inline,
     Global => (In_Out => Cells),
     Pre    => Where <= Last_RAM_Word;

end Devices.Processor_Memories;
