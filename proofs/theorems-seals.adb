--  SPDX-License-Identifier: Apache-2.0

with Interfaces; use Interfaces;

package body Theorems.Seals with SPARK_Mode is

   --  The tag stands behind what it covers.
   procedure Tag_Leaves_The_Rest
     (Block  : Block_Data;
      Sender : Station;
      Number : Counter;
      Inside : Session)
   with
     Global => null,
     Post   =>
       Tag_Of
         (With_Tag
            (Block, Sender,
             Tag_Of (Block, Sender, Number, Key_Of (Inside, Sender))),
          Sender, Number, Key_Of (Inside, Sender)) =
       Tag_Of (Block, Sender, Number, Key_Of (Inside, Sender));

   procedure Tag_Leaves_The_Rest
     (Block  : Block_Data;
      Sender : Station;
      Number : Counter;
      Inside : Session)
   is
      Tagged_One : constant Block_Data :=
        With_Tag
          (Block, Sender,
           Tag_Of (Block, Sender, Number, Key_Of (Inside, Sender)));
      Before : constant Message := Message_Of (Block, Sender, Number);
      After  : constant Message := Message_Of (Tagged_One, Sender, Number);
   begin
      pragma Assert
        (for all Where in Message_Index =>
           Before.Bytes (Where) = After.Bytes (Where));
      pragma Assert (Before = After);
   end Tag_Leaves_The_Rest;

   --  Within 4096 in a row each has a remainder of its own.
   procedure Same_Remainder (Left, Right : Counter)
   with
     Global => null,
     Pre    =>
       Left mod Numbers_Told = Right mod Numbers_Told
       and then abs (Left - Right) < Numbers_Told,
     Post   => Left = Right;

   --  Four bytes tell a number.
   procedure Bytes_Tell (Number : Counter; Block : Block_Data)
   with
     Global => null,
     Pre    =>
       Block (Before_Counter + 1) = Byte_Of (Number, 1)
       and then Block (Before_Counter + 2) = Byte_Of (Number, 2)
       and then Block (Before_Counter + 3) = Byte_Of (Number, 3)
       and then Block (Before_Counter + 4) = Byte_Of (Number, 4),
     Post   => Number_At (Block) = Number;

   procedure Same_Remainder (Left, Right : Counter) is
      Of_Left  : constant Counter := Left / Numbers_Told;
      Of_Right : constant Counter := Right / Numbers_Told;
   begin
      pragma Assert (Left = Numbers_Told * Of_Left + Left mod Numbers_Told);
      pragma Assert
        (Right = Numbers_Told * Of_Right + Right mod Numbers_Told);
      pragma Assert
        (if Of_Left > Of_Right
         then Numbers_Told * Of_Left >= Numbers_Told * Of_Right
                                        + Numbers_Told);
      pragma Assert
        (if Of_Right > Of_Left
         then Numbers_Told * Of_Right >= Numbers_Told * Of_Left
                                         + Numbers_Told);
      pragma Assert (Of_Left = Of_Right);
   end Same_Remainder;

   procedure Bytes_Tell (Number : Counter; Block : Block_Data) is
      Upper   : constant Counter := Number / 2 ** 8;
      Highest : constant Counter := Upper / 2 ** 8;
      First   : constant Counter := Highest / 2 ** 8;
   begin
      pragma Assert (Highest = Number / 2 ** 16);
      pragma Assert (First = Number / 2 ** 24);
      pragma Assert (First <= 127);
      pragma Assert (Counter (Block (Before_Counter + 1)) = First);
      pragma Assert
        (Counter (Block (Before_Counter + 2)) = Highest mod 2 ** 8);
      pragma Assert
        (Counter (Block (Before_Counter + 3)) = Upper mod 2 ** 8);
      pragma Assert
        (Counter (Block (Before_Counter + 4)) = Number mod 2 ** 8);
      pragma Assert (Number = 2 ** 8 * Upper + Number mod 2 ** 8);
      pragma Assert (Upper = 2 ** 8 * Highest + Upper mod 2 ** 8);
      pragma Assert (Highest = 2 ** 8 * First + Highest mod 2 ** 8);
   end Bytes_Tell;

   procedure Words_Come_Through
     (Data   : Block_Data;
      Sender : Station;
      Number : Counter;
      Inside : Session;
      Which  : Word_Place)
   is
      Without : constant Block_Data := Packed (Data, Sender, Number);
      Block   : constant Block_Data := Sealed (Data, Sender, Number, Inside);
   begin
      pragma Assert (Field_At (Block, Which) = Field_At (Without, Which));
      pragma Assert (Block (1) = Without (1));
      pragma Assert
        ((Block (1) and 16#0F#)
           = Byte (Word_At (Data, Words_Of (Sender)) mod 16));
   end Words_Come_Through;

   procedure What_Is_Sealed_Opens
     (Data   : Block_Data;
      Sender : Station;
      Number : Counter;
      Mine   : Session;
      Theirs : Session)
   is
      Without  : constant Block_Data := Packed (Data, Sender, Number);
      Block    : constant Block_Data := Sealed (Data, Sender, Number, Mine);
      Told_Low : constant Field := Field_At (Block, Uplink_Words);
   begin
      Tag_Leaves_The_Rest (Without, Sender, Number, Mine);
      if Sender = Ground then
         pragma Assert (Told_Low = Field_At (Without, Uplink_Words));
         pragma Assert (Told_Low = Word (Number mod Numbers_Told));
         pragma Assert
           (Counter (Word (Number mod Numbers_Told))
              = Number mod Numbers_Told);
         pragma Assert
           (Following (Theirs.Newest, Told_Low) mod Numbers_Told
              = Counter (Told_Low));
         Same_Remainder (Following (Theirs.Newest, Told_Low), Number);
      else
         pragma Assert
           (for all Where in Byte_Index range 1 .. 4 =>
              Block (Before_Counter + Where) = Byte_Of (Number, Where));
         pragma Assert (Block (Before_Counter + 1) = Byte_Of (Number, 1));
         pragma Assert (Block (Before_Counter + 2) = Byte_Of (Number, 2));
         pragma Assert (Block (Before_Counter + 3) = Byte_Of (Number, 3));
         pragma Assert (Block (Before_Counter + 4) = Byte_Of (Number, 4));
         Bytes_Tell (Number, Block);
      end if;
      pragma Assert
        (Number_Of (Block, Sender, Theirs.Newest) = Number);
      pragma Assert
        (Has_Tag
           (Block, Sender,
            Tag_Of (Without, Sender, Number, Key_Of (Mine, Sender))));
   end What_Is_Sealed_Opens;

   procedure Nothing_Older_Is_Taken
     (Item  : in out URV.Seals.Seal;
      Block : in out Block_Data;
      Came  : Boolean;
      What  : out Outcome) is
   begin
      Open (Item, Block, Came, What);
   end Nothing_Older_Is_Taken;

   procedure What_Is_Refused_Changes_Nothing
     (Item  : in out URV.Seals.Seal;
      Block : in out Block_Data;
      What  : out Outcome) is
   begin
      Open (Item, Block, True, What);
   end What_Is_Refused_Changes_Nothing;

   procedure Own_Nonces_Are_Used_Once
     (Item  : in out URV.Seals.Seal;
      Block : in out Block_Data;
      What  : out Outcome) is
   begin
      Open (Item, Block, True, What);
   end Own_Nonces_Are_Used_Once;

end Theorems.Seals;
