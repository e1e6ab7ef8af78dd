--  SPDX-License-Identifier: Apache-2.0

package body Machine_Texts is

   procedure Put_Line (Text : String := "") is
   begin
      Put (Text);
      Put ((1 => Character'Val (10)));
   end Put_Line;

   procedure Put_Labelled (Name : String; Value : Unsigned_32) is
      Digits_Of : String (1 .. 10);
      First     : Positive    := Digits_Of'Last + 1;
      Rest      : Unsigned_32 := Value;
   begin
      loop
         First := First - 1;
         Digits_Of (First) := Character'Val (48 + Rest mod 10);
         Rest := Rest / 10;
         exit when Rest = 0;
      end loop;
      Put (" ");
      Put (Name);
      Put (" ");
      Put (Digits_Of (First .. Digits_Of'Last));
   end Put_Labelled;

   procedure Put_Word (Value : Unsigned_16) is
      Text : String (1 .. 5) := (others => ' ');
      Rest : Unsigned_16 := Value;
   begin
      for Place in reverse 2 .. 5 loop
         Text (Place) := Character'Val
           (if Rest mod 16 < 10 then 48 + Rest mod 16 else 87 + Rest mod 16);
         Rest := Rest / 16;
      end loop;
      Put (Text);
   end Put_Word;

end Machine_Texts;
