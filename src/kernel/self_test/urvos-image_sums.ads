--  SPDX-License-Identifier: Apache-2.0

--  The checksum of a program image: CRC-32C (TST-1, TST-3), low bit first,
--  first value all ones. Its polynomial is that of iSCSI and SCTP,
--  1EDC6F41h.
--
--  The image keeps its own sum in its last four bytes, low byte first and
--  complemented. After all bytes, including those four, the register is
--  Good_Image for every sound image. A check therefore needs the image alone.
--
--  The register detects every change within one byte, which Theorems.Self_Test
--  proves, and every burst of up to 32 bits. The polynomial has the factor x +
--  1 and a period of 2**31 - 1 bits, so the register also detects up to three
--  wrong bits anywhere in an image.

with Interfaces;

with URVOS.Memories; use URVOS.Memories;

package URVOS.Image_Sums with Pure, SPARK_Mode is

   --  GNAT 12 crashes when it checks a variant at run time here. The proof
   --  shows that the recursion below ends.
   pragma Assertion_Policy (Subprogram_Variant => Ignore);

   type Sum is new Interfaces.Unsigned_32;

   First_Value : constant Sum := 16#FFFF_FFFF#;

   Good_Image : constant Sum := 16#B798_B438#;

   --  The value that the register takes up for the four bits that leave it. A
   --  table of 256 values for whole bytes is faster but fills 1 KiB.
   subtype Four_Bits is Sum range 0 .. 15;

   Given_Back : constant array (Four_Bits) of Sum :=
     (16#0000_0000#, 16#105E_C76F#, 16#20BD_8EDE#, 16#30E3_49B1#,
      16#417B_1DBC#, 16#5125_DAD3#, 16#61C6_9362#, 16#7198_540D#,
      16#82F6_3B78#, 16#92A8_FC17#, 16#A24B_B5A6#, 16#B215_72C9#,
      16#C38D_26C4#, 16#D3D3_E1AB#, 16#E330_A81A#, 16#F36E_6F75#);

   function Four_Bits_On (Register : Sum) return Sum is
     (Shift_Right (Register, 4) xor Given_Back (Register and 15))
   with
     Inline,
     Global => null;

   --  The register after one more byte.
   function Next (Register : Sum; Data : Byte) return Sum is
     (Four_Bits_On (Four_Bits_On (Register xor Sum (Data))))
   with
     Inline,
     Global => null;

   --  The register after the first Length bytes of an image. Only contracts
   --  call it.
   function Register_After (Item : Image; Length : Image_Length) return Sum
   is
     (if Length = 0 then First_Value
      else Next (Register_After (Item, Length - 1),
                 Item (Byte_Address (Length - 1))))
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Length),
     Pre                => Item'First = 0 and then Length <= Item'Length;

   --  The byte at each place of the image's last four, where Register is the
   --  sum of the bytes before them.

   type Sum_Place is range 0 .. 3;

   function Kept_Byte (Register : Sum; Place : Sum_Place) return Byte is
     (Byte (Shift_Right (not Register, 8 * Natural (Place)) and 16#FF#))
   with Global => null;

end URVOS.Image_Sums;
