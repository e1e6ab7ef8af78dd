--  SPDX-License-Identifier: Apache-2.0

--  The addresses by which the self-test reaches a processor's memories
--  (report, 2.4; TST-1): the ROM by bytes, the RAM by words.

package URVOS.Memories with Pure, SPARK_Mode is

   --  The address bus is 24 bits wide. Addresses count from the first byte or
   --  word of each memory.
   type Byte_Address is range 0 .. 2 ** 24 - 1;

   type Word_Address is range 0 .. 2 ** 23 - 1;

   --  The number of bytes of an image.
   type Image_Length is range 0 .. 2 ** 24;

   --  A whole image. Contracts and tests use it; the flight software reads
   --  byte by byte.
   type Image is array (Byte_Address range <>) of Byte
   with Alignment => 2;

end URVOS.Memories;
