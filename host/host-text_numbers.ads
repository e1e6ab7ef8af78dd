--  SPDX-License-Identifier: Apache-2.0

--  Numbers as people write them in options and input files. Nothing is
--  guessed: no sign, no blanks, no digit separators, no overflow.

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

   --  Whole or with at most so many decimals; the value counts units of
   --  the last of them. "0.5" with three decimals is 500.
   procedure Read_Decimal
     (Text     : String;
      Decimals : Natural;
      Value    : out Number;
      Is_Valid : out Boolean);

   --  How the value is written, without a leading blank.
   function Image (Value : Long_Long_Integer) return String;

   --  A number of thousandths, with no more decimals than it takes: "1.392".
   function Thousandths_Image (Value : Number) return String;

   --  In hexadecimal digits, without a mark.
   function Hexadecimal_Image (Value : Number) return String;

end Host.Text_Numbers;
