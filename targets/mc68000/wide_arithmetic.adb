--  SPDX-License-Identifier: Apache-2.0

with Wide_Division; use Wide_Division;

package body Wide_Arithmetic is

   pragma Suppress (All_Checks);

   function Low (Item : Unsigned_64) return Unsigned_32 is
     (Unsigned_32 (Item and 16#FFFF_FFFF#));

   function High (Item : Unsigned_64) return Unsigned_32 is
     (Unsigned_32 (Shift_Right (Item, 32)));

   --  A product of 16 by 16 bits is one instruction.
   function Wide (A, B : Unsigned_16) return Unsigned_32 is
     (Unsigned_32 (A) * Unsigned_32 (B));

   function Wide (A, B : Unsigned_32) return Unsigned_64;

   function Wide (A, B : Unsigned_32) return Unsigned_64 is
      A_Low  : constant Unsigned_16 := Unsigned_16 (A and 16#FFFF#);
      A_High : constant Unsigned_16 := Unsigned_16 (Shift_Right (A, 16));
      B_Low  : constant Unsigned_16 := Unsigned_16 (B and 16#FFFF#);
      B_High : constant Unsigned_16 := Unsigned_16 (Shift_Right (B, 16));
      One    : constant Unsigned_32 := Wide (A_High, B_Low);
      Middle : Unsigned_32          := One + Wide (A_Low, B_High);
      Top    : Unsigned_32          := Wide (A_High, B_High);
      Bottom : constant Unsigned_32 := Wide (A_Low, B_Low);
   begin
      if Middle < One then
         Top := Top + 2 ** 16;
      end if;
      Top := Top + Shift_Right (Middle, 16);
      Middle := Shift_Left (Middle, 16);
      if Bottom + Middle < Bottom then
         Top := Top + 1;
      end if;
      return Shift_Left (Unsigned_64 (Top), 32)
        or Unsigned_64 (Bottom + Middle);
   end Wide;

   function Product (A, B : Unsigned_64) return Unsigned_64 is
     (Wide (Low (A), Low (B))
      + Shift_Left
          (Unsigned_64 (High (A) * Low (B) + Low (A) * High (B)), 32));

   function Quotient (A, B : Unsigned_64) return Unsigned_64 is
      Both : Result;
   begin
      Divide (A, B, Both);
      return Both.Quotient;
   end Quotient;

   function Remainder (A, B : Unsigned_64) return Unsigned_64 is
      Both : Result;
   begin
      Divide (A, B, Both);
      return Both.Remainder;
   end Remainder;

   function Signed_Quotient (A, B : Unsigned_64) return Unsigned_64 is
      Both : Result;
   begin
      Divide_Signed (A, B, Both);
      return Both.Quotient;
   end Signed_Quotient;

   function Signed_Remainder (A, B : Unsigned_64) return Unsigned_64 is
      Both : Result;
   begin
      Divide_Signed (A, B, Both);
      return Both.Remainder;
   end Signed_Remainder;

end Wide_Arithmetic;
