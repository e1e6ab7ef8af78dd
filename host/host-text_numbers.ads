--  SPDX-License-Identifier: Apache-2.0

--  Numbers in options and input files. The syntax is strict: no sign, no
--  blanks, no digit separators, no overflow.

with Interfaces;

package Host.Text_Numbers is

   subtype Number is Interfaces.Unsigned_64;

   --  Decimal digits only.
   procedure Read_Whole
     (Text     : String;
      Value    : out Number;
      Is_Valid : out Boolean);

   --  Hexadecimal digits, with or without "0x".
   procedure Read_Hexadecimal
     (Text     : String;
      Value    : out Number;
      Is_Valid : out Boolean);

   --  A decimal number, or a hexadecimal one after "0x".
   procedure Read_Either
     (Text     : String;
      Value    : out Number;
      Is_Valid : out Boolean);

   --  A whole number or one with at most that number of decimals; the value
   --  counts units of the last decimal. "0.5" with three decimals is 500.
   procedure Read_Decimal
     (Text     : String;
      Decimals : Natural;
      Value    : out Number;
      Is_Valid : out Boolean);

   --  The value as text, without a leading blank.
   function Image (Value : Long_Long_Integer) return String;

   --  A number of thousandths, with no superfluous decimals: "1.392".
   function Thousandths_Image (Value : Number) return String;

   --  In hexadecimal digits, without a prefix.
   function Hexadecimal_Image (Value : Number) return String;

end Host.Text_Numbers;
