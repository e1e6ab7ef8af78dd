--  SPDX-License-Identifier: Apache-2.0

--  64-bit products, by the name that the compiler calls, and quotients, which
--  arithmetic.s calls.

with Interfaces; use Interfaces;

package Wide_Arithmetic is

   function Product (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "__muldi3";

   function Quotient (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "urv_quotient";

   function Remainder (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "urv_remainder";

   --  These numbers are in two's complement.

   function Signed_Quotient (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "urv_signed_quotient";

   function Signed_Remainder (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "urv_signed_remainder";

end Wide_Arithmetic;
