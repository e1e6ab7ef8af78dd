--  SPDX-License-Identifier: Apache-2.0

--  The checksum of a program image (TST-1, TST-3): two sums of its long words,
--  64 bits together, as the P and Q of RAID 6. Each step is a few instructions
--  of a processor without a barrel shifter, and needs no table.
--
--  A long is a polynomial of degree 31 over bits. Parity is the sum of all
--  longs. Remainder is their sum by Horner's rule at x, modulo the primitive
--  polynomial x^32 + x^7 + x^6 + x^2 + 1.
--
--  The image keeps in its last two longs the values that make both sums those
--  of Good_Image. A check therefore needs the image alone.
--
--  The sums detect every change within one long or two neighbouring ones,
--  which Theorems.Self_Test proves; these include every burst of up to 33
--  bits. They detect every change of an odd number of bits, by Parity. The
--  polynomial has a period of 2**32 - 1 longs, more than an image has, so they
--  detect every change within any two longs. They therefore detect up to three
--  wrong bits anywhere.

with URVOS.Memories; use URVOS.Memories;

package URVOS.Image_Sums with Pure, SPARK_Mode is

   --  GNAT 12 crashes when it checks a variant at run time here. The proof
   --  shows that the recursion below ends.
   pragma Assertion_Policy (Subprogram_Variant => Ignore);

   type Sum is record
      Parity    : Long;
      Remainder : Long;
   end record;

   --  An image of zeros is not good.
   First_Value : constant Sum := (others => 16#FFFF_FFFF#);

   Good_Image : constant Sum := (others => 0);

   --  x^32 modulo the polynomial, and this divided by x + 1.
   X_32         : constant Long := 16#C5#;
   X_32_Divided : constant Long := 16#43#;

   --  Value times x, modulo the polynomial.
   function Times_X (Value : Long) return Long is
     (if Value >= 2 ** 31 then Shift_Left (Value, 1) xor X_32
      else Shift_Left (Value, 1))
   with
     Inline,
     Global => null;

   --  The sums after one more long.
   function Next (This : Sum; Data : Long) return Sum is
     ((Parity    => This.Parity xor Data,
       Remainder => Times_X (This.Remainder) xor Data))
   with
     Inline,
     Global => null;

   --  The sums of the first Length longs of an image. Only contracts call it.
   function Sum_After (Item : Image; Length : Image_Length) return Sum is
     (if Length = 0 then First_Value
      else Next (Sum_After (Item, Length - 1),
                 Item (Long_Address (Length - 1))))
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Length),
     Pre                => Item'First = 0 and then Length <= Item'Length;

   --  The last two longs of an image, from the sums of those before them. They
   --  solve two equations, which needs a division by x + 1.

   function With_Lower_Bits (Value : Long; Places : Natural) return Long is
     (Value xor Shift_Left (Value, Places))
   with Global => null, Pre => Places < 32;

   --  Each bit of the result is the sum of this bit of Value and all lower
   --  ones.
   function Running_Sums (Value : Long) return Long is
     (With_Lower_Bits (With_Lower_Bits (With_Lower_Bits (With_Lower_Bits
        (With_Lower_Bits (Value, 16), 8), 4), 2), 1))
   with Global => null;

   --  Value divided by x + 1, modulo the polynomial.
   function Divided (Value : Long) return Long is
     (if Running_Sums (Value) >= 2 ** 31
      then Running_Sums (Value) xor X_32_Divided
      else Running_Sums (Value))
   with Global => null;

   type Kept_Place is range 0 .. 1;

   function Kept_Long (This : Sum; Place : Kept_Place) return Long is
     (Divided (Times_X (Times_X (This.Remainder)) xor This.Parity)
      xor (if Place = 0 then 0 else This.Parity))
   with Global => null;

end URVOS.Image_Sums;
