--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Test_Cards with SPARK_Mode is

   --  A sum with another word is another sum, for each weight.
   procedure Sums_Differ (By : Weight; Rest : Word; One, Other : Field)
   with
     Global => null,
     Pre    => One /= Other and then By mod 2 = 1,
     Post   =>
       (Rest + By * One) mod 4_096 /= (Rest + By * Other) mod 4_096;

   procedure Sums_Differ (By : Weight; Rest : Word; One, Other : Field) is
   begin
      case By is
         when 1 =>
            pragma Assert
              ((Rest + 1 * One) mod 4_096 /= (Rest + 1 * Other) mod 4_096);
         when 3 =>
            pragma Assert
              ((Rest + 3 * One) mod 4_096 /= (Rest + 3 * Other) mod 4_096);
         when 5 =>
            pragma Assert
              ((Rest + 5 * One) mod 4_096 /= (Rest + 5 * Other) mod 4_096);
         when 7 =>
            pragma Assert
              ((Rest + 7 * One) mod 4_096 /= (Rest + 7 * Other) mod 4_096);
         when 9 =>
            pragma Assert
              ((Rest + 9 * One) mod 4_096 /= (Rest + 9 * Other) mod 4_096);
         when 11 =>
            pragma Assert
              ((Rest + 11 * One) mod 4_096 /= (Rest + 11 * Other) mod 4_096);
         when 13 =>
            pragma Assert
              ((Rest + 13 * One) mod 4_096 /= (Rest + 13 * Other) mod 4_096);
         when 15 =>
            pragma Assert
              ((Rest + 15 * One) mod 4_096 /= (Rest + 15 * Other) mod 4_096);
         when 17 =>
            pragma Assert
              ((Rest + 17 * One) mod 4_096 /= (Rest + 17 * Other) mod 4_096);
         when 19 =>
            pragma Assert
              ((Rest + 19 * One) mod 4_096 /= (Rest + 19 * Other) mod 4_096);
         when others =>
            pragma Assert
              ((Rest + 21 * One) mod 4_096 /= (Rest + 21 * Other) mod 4_096);
      end case;
   end Sums_Differ;

   --  The same for an item of a card.
   procedure Other_Item_Other_Sum
     (Source : Card; Item : Card_Item; To : Field)
   with
     Global => null,
     Pre    => To /= Source (Item),
     Post   => Sum_Of ((Source with delta Item => To)) /= Sum_Of (Source);

   procedure Other_Item_Other_Sum
     (Source : Card; Item : Card_Item; To : Field)
   is
      By     : constant Weight := Weight_Of (Item);
      After  : constant Card   := (Source with delta Item => To);
      Before : Word := 0;
      Later  : Word := 0;
      Rest   : Word := 0;
   begin
      --  Rest is the sum of the other items.
      for Name in Card_Item loop
         Before := Before + Weight_Of (Name) * Source (Name);
         if Name = Item then
            pragma Assert (After (Name) = To);
            Later := Later + By * To;
         else
            pragma Assert (After (Name) = Source (Name));
            Later := Later + Weight_Of (Name) * Source (Name);
            Rest := Rest + Weight_Of (Name) * Source (Name);
         end if;
         pragma Loop_Invariant (Before = Sum_Up_To (Source, Name));
         pragma Loop_Invariant (Later = Sum_Up_To (After, Name));
         pragma Loop_Invariant
           (if Name < Item then Before = Rest and then Later = Rest
            else Before = Rest + By * Source (Item)
              and then Later = Rest + By * To);
      end loop;
      Sums_Differ (By, Rest, Source (Item), To);
   end Other_Item_Other_Sum;

   --  Equal cards have equal sums.
   procedure Same_Sum (One, Other : Card)
   with
     Global => null,
     Pre    => (for all Item in Card_Item => One (Item) = Other (Item)),
     Post   => Sum_Of (One) = Sum_Of (Other);

   procedure Same_Sum (One, Other : Card) is
   begin
      for Name in Card_Item loop
         pragma Loop_Invariant
           (Sum_Up_To (One, Name) = Sum_Up_To (Other, Name));
      end loop;
   end Same_Sum;

   procedure What_Is_Sent_Comes (Source : Card) is
   begin
      Same_Sum (Card_Of (Block_Of (Source)), Source);
   end What_Is_Sent_Comes;

   function Item_Of (Where : Card_Word) return Card_Item is
     (case Where is
         when Pitch    => Head,
         when Yaw      => Surfaces,
         when Throttle => Amplitude,
         when Brake    => Time,
         when Switch_1 => First,
         when Switch_2 => Last,
         when Switch_3 => Attitude,
         when Switch_4 => Airflow,
         when Switch_5 => Slowest,
         when Switch_6 => Fastest,
         when Switch_7 => Lowest)
   with Global => null;

   procedure One_Wrong_Word_Is_Refused
     (Source : Card;
      Where  : Command_Item;
      Value  : Word;
      Before : Aboard;
      On     : Boolean)
   is
      Block : constant Uplink_Buffer :=
        (Block_Of (Source) with delta Where => Value);
      Item  : Card_Item;
   begin
      if Where in Card_Word and then Value in Field then
         Item := Item_Of (Where);
         Other_Item_Other_Sum (Source, Item, Value);
         pragma Assert
           (for all Name in Card_Item =>
              Card_Of (Block) (Name) =
                Card'(Source with delta Item => Value) (Name));
         Same_Sum (Card_Of (Block), (Source with delta Item => Value));
      elsif Where in Card_Word then
         pragma Assert (not Has_Fields (Block));
      elsif Where = Switch_8 then
         Same_Sum (Card_Of (Block), Source);
      end if;
      pragma Assert (not Is_Whole (Block));
      pragma Assert (Answer_To (Block, Before, On) = Not_Whole);
   end One_Wrong_Word_Is_Refused;

   procedure Taken_Cards_Are_In_Range
     (Block : Uplink_Buffer; Before : Aboard; On : Boolean)
   is null;

   procedure A_Scan_Has_Started_It
     (Deck    : Card_Deck;
      Frames  : History;
      Upto    : Frame_Number;
      After   : out Run;
      Started : out Boolean;
      Since   : out Frame_Number)
   is
      Before : Run;
   begin
      After := Nothing_Aboard.Run;
      Started := False;
      Since := 1;
      for Frame in 1 .. Upto loop
         Before := After;
         After := Next (Before, Deck, Frames (Frame));
         if Before.Running = 0 and then After.Running > 0 then
            pragma Assert (Is_Started (Before, Frames (Frame)));
            pragma Assert
              (Judged (Deck (After.Running), Frames (Frame)) = Well);
            Started := True;
            Since := Frame;
            pragma Assert
              (Frames (Since).Is_New
               and then Is_On (Frames (Since).Heard (Switch_5))
               and then Frames (Since).Is_Linked
               and then not Frames (Since).Is_Cut);
         end if;
         pragma Assert
           (if not Started
            then Before.Added = Nothing_Added and then After.Running = 0);
         pragma Assert
           (if not Started
            then
              (for all Which in Test_Surface =>
                 Before.Added (Which) = 0
                 and then Authority (Deck, After, Which) = 0));
         pragma Assert
           (if not Started
            then After.Running = 0
              and then
                (for all Which in Test_Surface => After.Added (Which) = 0));
         pragma Loop_Invariant
           (if After.Added /= Nothing_Added or else After.Running > 0
            then Started);
         pragma Loop_Invariant
           (if Started
            then Since <= Frame
              and then Frames (Since).Is_New
              and then Is_On (Frames (Since).Heard (Switch_5))
              and then Frames (Since).Is_Linked
              and then not Frames (Since).Is_Cut);
      end loop;
   end A_Scan_Has_Started_It;

   procedure Without_Cards_Nothing_Changes
     (This     : Run;
      Sight    : Situation;
      Servos   : PWM_Buffer;
      Commands : Uplink_Buffer)
   is
      After : constant Run := Next (This, No_Cards, Sight);
   begin
      pragma Assert
        (for all Which in Slot => not Is_Loaded (No_Cards (Which)));
      pragma Assert (After.Running = 0);
      if This.Added = Nothing_Added then
         pragma Assert
           (for all Which in Test_Surface => After.Added (Which) = 0);
         pragma Assert (After.Added = Nothing_Added);
         pragma Assert (With_Inputs (Servos, After.Added) = Servos);
         pragma Assert
           (for all Name in Command_Item =>
              With_Sticks (Commands, To_Sticks (After)) (Name) =
                Commands (Name));
      end if;
   end Without_Cards_Nothing_Changes;

   procedure Each_Input_Has_One_Place
     (This : Run; Deck : Card_Deck; Sight : Situation) is null;

   procedure It_Ends_In_One_Frame
     (This : Run; Deck : Card_Deck; Sight : Situation) is null;

   procedure Inputs_Return_To_0
     (This   : Run;
      Deck   : Card_Deck;
      Frames : History;
      Which  : Test_Surface;
      After  : out Run;
      Is_Run : out Boolean)
   is
   begin
      After := This;
      Is_Run := False;
      for Frame in Frame_Number range 1 .. Last_Frames loop
         After := Next (After, Deck, Frames (Frame));
         Is_Run := Is_Run or else After.Running > 0;
         pragma Loop_Invariant
           (if not Is_Run
            then abs After.Added (Which) <=
              Integer'Max
                (0, Most_Amplitude - Integer (Frame) * Rate_Step (Which)));
      end loop;
   end Inputs_Return_To_0;

end Theorems.Test_Cards;
