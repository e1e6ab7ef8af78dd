--  SPDX-License-Identifier: Apache-2.0

--  The sizes of the memories that the STM32F405's program and its self-test
--  use (BRD-3), as in image.ld.

with URVOS.Memories; use URVOS.Memories;

package Devices.Memory_Sizes with Pure, SPARK_Mode is

   --  96 KiB of flash memory, the sum of the image in its last four bytes,
   --  and 16 KiB of RAM.
   Last_ROM_Byte : constant Byte_Address := 16#1_7FFF#;
   Last_RAM_Word : constant Word_Address := 16#1FFF#;

end Devices.Memory_Sizes;
