--  SPDX-License-Identifier: Apache-2.0

--  The sizes of a processor board's memories, as in the report. A target
--  replaces this file by its own (BRD-3).

with URVOS.Memories; use URVOS.Memories;

package Devices.Memory_Sizes with Pure, SPARK_Mode is

   --  64 KiB of ROM, with the image's sum in the last eight bytes, and 16 KiB
   --  of RAM.
   Last_ROM_Long : constant Long_Address := 16#3FFF#;
   Last_RAM_Word : constant Word_Address := 16#1FFF#;

   --  The check in flight reads these in each major frame (TST-3).
   ROM_Longs_Per_Frame : constant := 16;

end Devices.Memory_Sizes;
