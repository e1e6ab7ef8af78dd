--  SPDX-License-Identifier: Apache-2.0

--  64-bit products and quotients, by the names that the compiler calls.

with Interfaces; use Interfaces;

package Wide_Arithmetic is

   function Product (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "__muldi3";

   function Quotient (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "__udivdi3";

   function Remainder (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "__umoddi3";

   --  These numbers are in two's complement.

   function Signed_Quotient (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "__divdi3";

   function Signed_Remainder (A, B : Unsigned_64) return Unsigned_64
   with Export, Convention => C, External_Name => "__moddi3";

end Wide_Arithmetic;
