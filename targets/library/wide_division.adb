--  SPDX-License-Identifier: Apache-2.0

package body Wide_Division is

   pragma Suppress (All_Checks);

   procedure Divide (A, B : Unsigned_64; R : out Result) is
      Quotient : Unsigned_64 := 0;
      Left     : Unsigned_64 := 0;
      Bits     : Unsigned_64 := A;
      Carry    : Boolean;
   begin
      if A < 2 ** 32 and then B < 2 ** 32 then
         R :=
           (Unsigned_64 (Unsigned_32 (A) / Unsigned_32 (B)),
            Unsigned_64 (Unsigned_32 (A) mod Unsigned_32 (B)));
         return;
      end if;
      for Bit in 1 .. 64 loop
         Carry := Left >= 2 ** 63;
         Left := Left + Left + (if Bits >= 2 ** 63 then 1 else 0);
         Bits := Bits + Bits;
         Quotient := Quotient + Quotient;
         if Carry or else Left >= B then
            Left := Left - B;
            Quotient := Quotient + 1;
         end if;
      end loop;
      R := (Quotient, Left);
   end Divide;

   function Is_Negative (Item : Unsigned_64) return Boolean is
     (Item >= 2 ** 63);

   function Size_Of (Item : Unsigned_64) return Unsigned_64 is
     (if Is_Negative (Item) then -Item else Item);

   procedure Divide_Signed (A, B : Unsigned_64; R : out Result) is
   begin
      Divide (Size_Of (A), Size_Of (B), R);
      if Is_Negative (A) /= Is_Negative (B) then
         R.Quotient := -R.Quotient;
      end if;
      if Is_Negative (A) then
         R.Remainder := -R.Remainder;
      end if;
   end Divide_Signed;

end Wide_Division;
