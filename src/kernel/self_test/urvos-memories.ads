--  SPDX-License-Identifier: Apache-2.0

--  How the self-test addresses a processor's memories (report, 2.4; TST-1):
--  the ROM byte by byte, the RAM word by word.

package URVOS.Memories with Pure, SPARK_Mode is

   --  The address bus is 24 bits wide. Addresses count from the memory's
   --  own first byte or word.
   type Byte_Address is range 0 .. 2 ** 24 - 1;

   type Word_Address is range 0 .. 2 ** 23 - 1;

   --  How many bytes of an image.
   type Image_Length is range 0 .. 2 ** 24;

   --  A whole image. Contracts and tests speak of it; the flight software
   --  reads byte by byte.
   type Image is array (Byte_Address range <>) of Byte;

end URVOS.Memories;
