--  SPDX-License-Identifier: Apache-2.0

--  64-bit divisions, which the compiler calls through start.s.

with Interfaces; use Interfaces;

package Wide_Division is

   type Result is record
      Quotient, Remainder : Unsigned_64;
   end record;

   procedure Divide (A, B : Unsigned_64; R : out Result)
   with Export, Convention => C, External_Name => "urv_divide_64";

   --  Both numbers are in two's complement.
   procedure Divide_Signed (A, B : Unsigned_64; R : out Result)
   with Export, Convention => C, External_Name => "urv_divide_64_signed";

end Wide_Division;
