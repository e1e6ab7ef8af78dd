--  SPDX-License-Identifier: Apache-2.0

--  The addresses by which the self-test reaches a processor's memories
--  (report, 2.4; TST-1): the ROM by longs, at the addresses of their first
--  bytes, the RAM by words.

with Interfaces;

package URVOS.Memories with Pure, SPARK_Mode is

   --  A long word has 32 bits, as the processor reads them at once.
   type Long is new Interfaces.Unsigned_32;

   --  The address bus is 24 bits wide. Addresses count from the first byte,
   --  long or word of each memory.
   type Byte_Address is range 0 .. 2 ** 24 - 1;

   type Long_Address is range 0 .. 2 ** 22 - 1;

   type Word_Address is range 0 .. 2 ** 23 - 1;

   --  The number of longs of an image.
   type Image_Length is range 0 .. 2 ** 22;

   Bytes_Per_Long : constant := 4;

   --  The address of a long's first byte.
   function Byte_Of (Where : Long_Address) return Byte_Address is
     (Bytes_Per_Long * Byte_Address (Where))
   with
     Inline,
     Global => null,
     Post   => Byte_Of'Result mod Bytes_Per_Long = 0;

   --  A whole image. Contracts and tests use it; the flight software reads
   --  long by long.
   type Image is array (Long_Address range <>) of Long;

end URVOS.Memories;
