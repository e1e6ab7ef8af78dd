--  SPDX-License-Identifier: Apache-2.0

package body Host.Text_Numbers is

   use type Number;

   --  Appends digits of the base to Value. Text must not be empty.
   procedure Read_Digits
     (Text     : String;
      Base     : Number;
      Value    : in out Number;
      Is_Valid : out Boolean);

   function Has_Hexadecimal_Mark (Text : String) return Boolean is
     (Text'Length > 2
      and then Text (Text'First) = '0'
      and then Text (Text'First + 1) in 'x' | 'X');

   procedure Read_Digits
     (Text     : String;
      Base     : Number;
      Value    : in out Number;
      Is_Valid : out Boolean)
   is
      Digit : Number;
   begin
      Is_Valid := Text'Length > 0;
      for Char of Text loop
         case Char is
            when '0' .. '9' =>
               Digit := Character'Pos (Char) - Character'Pos ('0');
            when 'a' .. 'f' =>
               Digit := Character'Pos (Char) - Character'Pos ('a') + 10;
            when 'A' .. 'F' =>
               Digit := Character'Pos (Char) - Character'Pos ('A') + 10;
            when others =>
               Digit := Number'Last;
         end case;

         if Digit >= Base or else Value > (Number'Last - Digit) / Base then
            Is_Valid := False;
            return;
         end if;
         Value := Value * Base + Digit;
      end loop;
   end Read_Digits;

   procedure Read_Whole
     (Text     : String;
      Value    : out Number;
      Is_Valid : out Boolean)
   is
   begin
      Value := 0;
      Read_Digits (Text, 10, Value, Is_Valid);
   end Read_Whole;

   procedure Read_Hexadecimal
     (Text     : String;
      Value    : out Number;
      Is_Valid : out Boolean)
   is
   begin
      Value := 0;
      if Has_Hexadecimal_Mark (Text) then
         Read_Digits
           (Text (Text'First + 2 .. Text'Last), 16, Value, Is_Valid);
      else
         Read_Digits (Text, 16, Value, Is_Valid);
      end if;
   end Read_Hexadecimal;

   procedure Read_Either
     (Text     : String;
      Value    : out Number;
      Is_Valid : out Boolean)
   is
   begin
      if Has_Hexadecimal_Mark (Text) then
         Read_Hexadecimal (Text, Value, Is_Valid);
      else
         Read_Whole (Text, Value, Is_Valid);
      end if;
   end Read_Either;

   procedure Read_Decimal
     (Text     : String;
      Decimals : Natural;
      Value    : out Number;
      Is_Valid : out Boolean)
   is
      Point   : Natural := Text'Last + 1;
      Present : Natural := 0;
   begin
      for Index in Text'Range loop
         if Text (Index) = '.' then
            Point := Index;
            exit;
         end if;
      end loop;

      Read_Whole (Text (Text'First .. Point - 1), Value, Is_Valid);

      if Is_Valid and then Point <= Text'Last then
         Present := Text'Last - Point;
         if Present > Decimals then
            Is_Valid := False;
         else
            Read_Digits
              (Text (Point + 1 .. Text'Last), 10, Value, Is_Valid);
         end if;
      end if;

      for Missing in Present + 1 .. Decimals loop
         if Value > Number'Last / 10 then
            Is_Valid := False;
            return;
         end if;
         Value := Value * 10;
      end loop;
   end Read_Decimal;

   function Image (Value : Long_Long_Integer) return String is
      Text : constant String := Value'Image;
   begin
      return
        (if Value < 0 then Text else Text (Text'First + 1 .. Text'Last));
   end Image;

   function Thousandths_Image (Value : Number) return String is
      Text : constant String :=
        Image (Long_Long_Integer (1_000 + Value mod 1_000));
      Last : Positive := Text'Last;
   begin
      while Last > Text'First and then Text (Last) = '0' loop
         Last := Last - 1;
      end loop;
      return
        Image (Long_Long_Integer (Value / 1_000))
        & (if Last = Text'First then ""
           else "." & Text (Text'First + 1 .. Last));
   end Thousandths_Image;

   function Hexadecimal_Image (Value : Number) return String is
      Digit : constant String (1 .. 16) := "0123456789abcdef";
      Text  : String (1 .. 16);
      First : Positive := Text'Last;
      Rest  : Number   := Value;
   begin
      loop
         Text (First) := Digit (Positive (Rest mod 16 + 1));
         Rest := Rest / 16;
         exit when Rest = 0;
         First := First - 1;
      end loop;
      return Text (First .. Text'Last);
   end Hexadecimal_Image;

end Host.Text_Numbers;
