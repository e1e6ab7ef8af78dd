--  SPDX-License-Identifier: Apache-2.0

package body URV.Recorder_Rows with SPARK_Mode is

   --  Adds the next word.
   procedure Add (Value : Word; Sum, Partials : in out Word)
   with
     Inline,
     Global => null,
     Post   => Sum = Sum'Old + Value and then Partials = Partials'Old + Sum;

   --  The sums are those of the places up to this one.
   function Are_Sums
     (Number        : Row_Number;
      Words         : Recorded_Words;
      Place         : Content_Word;
      Sum, Partials : Word) return Boolean
   is
     (Sum = Sum_Up_To (Number, Words, Place)
      and then Partials = Partials_Up_To (Number, Words, Place))
   with Ghost, Global => null;

   --  The sums of a place, from those of the place before.
   procedure Unfold
     (Number : Row_Number; Words : Recorded_Words; Place : Content_Word)
   with
     Ghost,
     Global => null,
     Post   =>
       Sum_Up_To (Number, Words, Place) =
         (if Place = 1 then 0 else Sum_Up_To (Number, Words, Place - 1))
         + Content_Of (Number, Words, Place)
       and then
         Partials_Up_To (Number, Words, Place) =
           (if Place = 1 then 0 else Partials_Up_To (Number, Words, Place - 1))
           + Sum_Up_To (Number, Words, Place);

   procedure Unfold
     (Number : Row_Number; Words : Recorded_Words; Place : Content_Word)
   is null;

   procedure Add (Value : Word; Sum, Partials : in out Word) is
   begin
      Sum := Sum + Value;
      Partials := Partials + Sum;
   end Add;

   --  A loop for each part of a row: to find the part of each word takes
   --  longer than to add it.
   function Row_Of (Number : Row_Number; Words : Recorded_Words) return Row is
      Sum      : Word := 0;
      Partials : Word := 0;
   begin
      for Place in Content_Word'First .. Sensor_Word'First - 1 loop
         Add (Content_Of (Number, Words, Place), Sum, Partials);
         Unfold (Number, Words, Place);
         pragma Loop_Invariant
           (Are_Sums (Number, Words, Place, Sum, Partials));
      end loop;
      for Place in Sensor_Word loop
         Add (Words.Sensors (Item_Of (Place)), Sum, Partials);
         Unfold (Number, Words, Place);
         pragma Loop_Invariant
           (Are_Sums (Number, Words, Place, Sum, Partials));
      end loop;
      for Place in Command_Word loop
         Add (Words.Commands (Item_Of (Place)), Sum, Partials);
         Unfold (Number, Words, Place);
         pragma Loop_Invariant
           (Are_Sums (Number, Words, Place, Sum, Partials));
      end loop;
      for Place in Servo_Word loop
         Add (Words.Servos (Item_Of (Place)), Sum, Partials);
         Unfold (Number, Words, Place);
         pragma Loop_Invariant
           (Are_Sums (Number, Words, Place, Sum, Partials));
      end loop;
      for Place in Law_Word loop
         Add (Words.Laws (Place_Of (Place)), Sum, Partials);
         Unfold (Number, Words, Place);
         pragma Loop_Invariant
           (Are_Sums (Number, Words, Place, Sum, Partials));
      end loop;
      for Place in Other_Word loop
         Add (Content_Of (Number, Words, Place), Sum, Partials);
         Unfold (Number, Words, Place);
         pragma Loop_Invariant
           (Are_Sums (Number, Words, Place, Sum, Partials));
      end loop;
      return (Number, Words, Sum, Partials);
   end Row_Of;

end URV.Recorder_Rows;
