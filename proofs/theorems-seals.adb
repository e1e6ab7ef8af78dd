--  SPDX-License-Identifier: Apache-2.0

with Interfaces;                    use Interfaces;
with Theorems.Seals.Uplink_Numbers; use Theorems.Seals.Uplink_Numbers;

package body Theorems.Seals with SPARK_Mode is

   --  Equal messages have the same tag.
   procedure Prove_Same_Tag (Left, Right : Message; With_Key : Key)
   with
     Global => null,
     Pre    =>
       Left.Length = Right.Length
       and then
         (for all Where in Message_Index =>
            Left.Bytes (Where) = Right.Bytes (Where)),
     Post   => Tag (Left, With_Key) = Tag (Right, With_Key);

   procedure Prove_Same_Tag (Left, Right : Message; With_Key : Key) is
   begin
      for Which in Word_Count range 1 .. Words_Of (Left) loop
         pragma Assert
           (Word_At (Left, Which - 1) = Word_At (Right, Which - 1));
         pragma Loop_Invariant
           (After (Left, With_Key, Which) = After (Right, With_Key, Which));
      end loop;
   end Prove_Same_Tag;

   --  The tag follows the bytes that it covers.
   procedure Tag_Leaves_The_Rest
     (Block  : Block_Data;
      Sender : Station;
      Number : Counter;
      Echo   : Counter;
      Inside : Session)
   with
     Global => null,
     Post   =>
       Tag_Of
         (With_Tag
            (Block, Sender,
             Tag_Of (Block, Sender, Number, Echo, Key_Of (Inside, Sender))),
          Sender, Number, Echo, Key_Of (Inside, Sender)) =
       Tag_Of (Block, Sender, Number, Echo, Key_Of (Inside, Sender));

   procedure Tag_Leaves_The_Rest
     (Block  : Block_Data;
      Sender : Station;
      Number : Counter;
      Echo   : Counter;
      Inside : Session)
   is
      Tagged_One : constant Block_Data :=
        With_Tag
          (Block, Sender,
           Tag_Of (Block, Sender, Number, Echo, Key_Of (Inside, Sender)));
      Before : constant Message :=
        Message_Of (Block, Sender, Number, Echo);
      After  : constant Message :=
        Message_Of (Tagged_One, Sender, Number, Echo);
   begin
      Prove_Same_Tag (Before, After, Key_Of (Inside, Sender));
   end Tag_Leaves_The_Rest;

   --  Three bytes hold a number.
   procedure Bytes_Determine (Number : Counter; Block : Block_Data)
   with
     Global => null,
     Pre    =>
       Number <= Last_Age
       and then Block (Before_Counter + 2) = Byte_Of (Number, 2)
       and then Block (Before_Counter + 3) = Byte_Of (Number, 3)
       and then Block (Before_Counter + 4) = Byte_Of (Number, 4),
     Post   => Number_At (Block) = Number;

   procedure Bytes_Determine (Number : Counter; Block : Block_Data) is
      Upper   : constant Counter := Number / 2 ** 8;
      Highest : constant Counter := Upper / 2 ** 8;
   begin
      pragma Assert (Highest = Number / 2 ** 16);
      pragma Assert (Highest <= 255);
      pragma Assert (Counter (Block (Before_Counter + 2)) = Highest);
      pragma Assert
        (Counter (Block (Before_Counter + 3)) = Upper mod 2 ** 8);
      pragma Assert
        (Counter (Block (Before_Counter + 4)) = Number mod 2 ** 8);
      pragma Assert (Number = 2 ** 8 * Upper + Number mod 2 ** 8);
      pragma Assert (Upper = 2 ** 8 * Highest + Upper mod 2 ** 8);
   end Bytes_Determine;

   procedure Words_Come_Through
     (Data   : Block_Words;
      Sender : Station;
      Number : Counter;
      Echo   : Counter;
      Inside : Session;
      Which  : Word_Place)
   is
      Without : constant Block_Data := Packed (Data, Sender, Number, Echo);
      Block   : constant Block_Data :=
        Sealed (Data, Sender, Number, Echo, Inside);
   begin
      pragma Assert (Field_At (Block, Which) = Field_At (Without, Which));
      pragma Assert (Block (1) = Without (1));
      pragma Assert
        ((Block (1) and 16#0F#)
           = Byte (Data (Words_Of (Sender)) mod 16));
      if Sender = Aircraft then
         pragma Assert (Block (Before_Counter + 1) = Card_Of (Data));
         pragma Assert
           (for all Where in Byte_Index range 2 .. 4 =>
              Block (Before_Counter + Where) = Byte_Of (Number, Where));
         pragma Assert
           (Spare_In_Format_2 (Block, Which) =
              Spare_Carried (Data, Number, Which));
      end if;
   end Words_Come_Through;

   --  The number and the echo of a downlink are those with which it was
   --  sealed.
   procedure Downlink_Determines
     (Block  : Block_Data;
      Number : Counter;
      Echo   : Counter;
      Theirs : Session)
   with
     Global => null,
     Pre    =>
       Number <= Last_Age
       and then Block (Before_Counter) = Byte (Code_Of (Echo))
       and then
         (for all Where in Byte_Index range 2 .. 4 =>
            Block (Before_Counter + Where) = Byte_Of (Number, Where))
       and then Echo <= Theirs.Age
       and then (Echo = 0 or else Theirs.Age - Echo < Echo_Modulus),
     Post   =>
       Number_Of (Block, Aircraft, Theirs) = Number
       and then Echo_Of (Block, Aircraft, Theirs) = Echo;

   procedure Downlink_Determines
     (Block  : Block_Data;
      Number : Counter;
      Echo   : Counter;
      Theirs : Session) is
   begin
      Bytes_Determine (Number, Block);
      if Echo > 0 then
         The_Latest_Is_It (Echo, Echo_Modulus, Theirs.Age);
      end if;
   end Downlink_Determines;

   procedure A_Sealed_Block_Opens
     (Data   : Block_Words;
      Sender : Station;
      Number : Counter;
      Echo   : Counter;
      Mine   : Session;
      Theirs : Session)
   is
      Without : constant Block_Data := Packed (Data, Sender, Number, Echo);
      Block   : constant Block_Data :=
        Sealed (Data, Sender, Number, Echo, Mine);
   begin
      Tag_Leaves_The_Rest (Without, Sender, Number, Echo, Mine);
      if Sender = Ground then
         pragma Assert
           (Field_At (Block, Uplink_Words) =
              Field_At (Without, Uplink_Words));
         Uplink_Determines (Block, Number, Echo, Theirs);
      else
         pragma Assert
           (for all Where in Byte_Index range Before_Counter ..
              Before_Counter + 4 => Block (Where) = Without (Where));
         Downlink_Determines (Block, Number, Echo, Theirs);
      end if;
      pragma Assert
        (Has_Tag
           (Block, Sender,
            Tag_Of (Without, Sender, Number, Echo, Key_Of (Mine, Sender))));
   end A_Sealed_Block_Opens;

   procedure Nothing_Older_Is_Taken
     (Item    : in out URV.Handshakes.Seal;
      Block   : Block_Data;
      Arrived : Boolean;
      Words   : out Block_Words;
      Result  : out Outcome)
   is
      Was : constant URV.Handshakes.Seal := Item;
   begin
      Open (Item, Block, Arrived, Words, Result);
      if Result = Opened then
         pragma Assert (Opens (Block, Other (Was.Role), Was.Active));
         pragma Assert
           (Item.Active = With_Newest (Was.Active, Block, Other (Was.Role)));
      elsif Result = Opened_New_Session then
         pragma Assert (Opened_Place (Was, Block) > 0);
      end if;
   end Nothing_Older_Is_Taken;

   procedure Clocks_Keep_Step
     (Theirs : Counter; Mine : Counter; Time : Nanoseconds) is null;

   procedure A_Taken_Block_Is_Young
     (Item         : Session;
      Block        : Block_Data;
      Sender       : Station;
      Reference_At : Counter;
      Sealed_At    : Counter) is null;

   procedure The_Reference_Stays_True
     (Item         : Session;
      Block        : Block_Data;
      Sender       : Station;
      Reference_At : Counter;
      Sealed_At    : Counter) is null;

   procedure A_Call_Is_Answered
     (Item    : in out URV.Handshakes.Seal;
      Call    : Block_Data;
      Words   : out Block_Words;
      Result  : out Outcome) is
   begin
      Open (Item, Call, True, Words, Result);
   end A_Call_Is_Answered;

   procedure Each_Answer_Has_Its_Turn
     (Item  : in out URV.Handshakes.Seal;
      Which : Pending_Place) is
   begin
      pragma Assert (Is_Answered (Item.Pending (To_Answer (Item))));
      pragma Assert
        (Distance (Item.Turn, To_Answer (Item)) <=
           Distance (Item.Turn, Which));
      Pass (Item, 1);
   end Each_Answer_Has_Its_Turn;

   procedure A_Call_Displaces_The_Oldest
     (Item    : in out URV.Handshakes.Seal;
      Call    : Block_Data;
      Words   : out Block_Words;
      Result  : out Outcome)
   is
      Was : constant URV.Handshakes.Seal := Item;
   begin
      pragma Assert (Outcome_Of (Item, Call, True) not in Taken);
      Open (Item, Call, True, Words, Result);
      if Result = Hello_Taken then
         pragma Assert (Item = After_Hello (Was, Call));
      else
         pragma Assert (Item = Was);
      end if;
   end A_Call_Displaces_The_Oldest;

   procedure A_Sealed_Block_Completes
     (Item   : in out URV.Handshakes.Seal;
      Block  : Block_Data;
      Which  : Pending_Place;
      Words  : out Block_Words;
      Result : out Outcome) is
   begin
      pragma Assert
        (Opened_Place (Item, Block) in 1 .. Pending_Count (Which));
      Open (Item, Block, True, Words, Result);
   end A_Sealed_Block_Completes;

   procedure A_Refused_Block_Changes_Nothing
     (Item   : in out URV.Handshakes.Seal;
      Block  : Block_Data;
      Words  : out Block_Words;
      Result : out Outcome) is
   begin
      Open (Item, Block, True, Words, Result);
   end A_Refused_Block_Changes_Nothing;

   procedure Keys_Remain
     (Item   : URV.Handshakes.Seal;
      Block  : Block_Data;
      Frames : Counter) is null;

   procedure Own_Nonces_Are_Used_Once
     (Item   : in out URV.Handshakes.Seal;
      Block  : Block_Data;
      Words  : out Block_Words;
      Result : out Outcome) is
   begin
      Open (Item, Block, True, Words, Result);
   end Own_Nonces_Are_Used_Once;

end Theorems.Seals;
