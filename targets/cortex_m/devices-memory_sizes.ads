--  SPDX-License-Identifier: Apache-2.0

--  The sizes of the STM32F405's memories for the program and its self-test
--  (BRD-3), as in image.ld.

with URVOS.Memories; use URVOS.Memories;

package Devices.Memory_Sizes with Pure, SPARK_Mode is

   --  112 KiB of flash memory, with the image's sum in the last eight bytes,
   --  and 4 KiB of RAM.
   Last_ROM_Long : constant Long_Address := 16#6FFF#;
   Last_RAM_Word : constant Word_Address := 16#7FF#;

   --  The check in flight reads these in each major frame (TST-3).
   ROM_Longs_Per_Frame : constant := 16;

   --  The long words of variables and stack, and those that the march in
   --  flight tests in a minor frame (TST-5).
   RAM_Cells          : constant := 64 * 1024 / 4;
   RAM_Cells_Per_Tick : constant := 4;

end Devices.Memory_Sizes;
