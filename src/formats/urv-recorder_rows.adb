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

   procedure Add (Value : Word; Sum, Partials : in out Word) is
   begin
      Sum := Sum + Value;
      Partials := Partials + Sum;
   end Add;

   --  A loop for each part that a row has: finding a part for each word takes
   --  longer than adding it.
   function Row_Of (Number : Row_Number; Words : Recorded_Words) return Row is
      Sum      : Word := 0;
      Partials : Word := 0;
   begin
      for Place in Content_Word range 1 .. 4 loop
         Sum := Sum + Content_Of (Number, Words, Place);
         Partials := Partials + Sum;
         pragma Assert
           (Partials_Up_To (Number, Words, Place) =
              (if Place = 1 then 0
               else Partials_Up_To (Number, Words, Place - 1))
              + Sum_Up_To (Number, Words, Place));
         pragma Loop_Invariant (Sum = Sum_Up_To (Number, Words, Place));
         pragma Loop_Invariant
           (Partials = Partials_Up_To (Number, Words, Place));
      end loop;
      for Item in Downlink_Item'Val (0) .. Downlink_Item'Val (32 - 5) loop
         Add (Words.Sensors (Item), Sum, Partials);
         pragma Loop_Invariant
           (Are_Sums
              (Number, Words, Downlink_Item'Pos (Item) + 5, Sum, Partials));
      end loop;
      for Item in Uplink_Item'Val (0) .. Uplink_Item'Val (46 - 33) loop
         Add (Words.Commands (Item), Sum, Partials);
         pragma Loop_Invariant
           (Are_Sums
              (Number, Words, Uplink_Item'Pos (Item) + 33, Sum, Partials));
      end loop;
      for Item in PWM_Item'Val (0) .. PWM_Item'Val (60 - 47) loop
         Add (Words.Servos (Item), Sum, Partials);
         pragma Loop_Invariant
           (Are_Sums
              (Number, Words, PWM_Item'Pos (Item) + 47, Sum, Partials));
      end loop;
      for Item in Law_Place loop
         Add (Words.Laws (Item), Sum, Partials);
         pragma Loop_Invariant
           (Are_Sums
              (Number, Words, Content_Word (Item) + 60, Sum, Partials));
      end loop;
      for Place in Content_Word range 67 .. 70 loop
         Sum := Sum + Content_Of (Number, Words, Place);
         Partials := Partials + Sum;
         pragma Assert
           (Partials_Up_To (Number, Words, Place) =
              Partials_Up_To (Number, Words, Place - 1)
              + Sum_Up_To (Number, Words, Place));
         pragma Loop_Invariant (Sum = Sum_Up_To (Number, Words, Place));
         pragma Loop_Invariant
           (Partials = Partials_Up_To (Number, Words, Place));
      end loop;
      return (Number, Words, Sum, Partials);
   end Row_Of;

end URV.Recorder_Rows;
