--  SPDX-License-Identifier: Apache-2.0

--  The sizes of a processor board's memories. These are the report's; a
--  target has a file of its own in the place of this one (BRD-3).

with URVOS.Memories; use URVOS.Memories;

package Devices.Memory_Sizes with Pure, SPARK_Mode is

   --  64 KiB of ROM, the sum of the image in its last four bytes, and
   --  16 KiB of RAM.
   Last_ROM_Byte : constant Byte_Address := 16#FFFF#;
   Last_RAM_Word : constant Word_Address := 16#1FFF#;

end Devices.Memory_Sizes;
