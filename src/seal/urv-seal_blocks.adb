--  SPDX-License-Identifier: Apache-2.0

package body URV.Seal_Blocks with SPARK_Mode is

   function Packed
     (Data   : Block_Words;
      Sender : Station;
      Number : Counter;
      Echo   : Counter) return Block_Data
   is
      Result : Block_Data := [others => 0];
      First  : Field;
      Second : Field;
   begin
      Result (1) := Sealed_Mark or Byte (Data (Words_Of (Sender)) mod 16);

      for Pair in Byte_Index range 1 .. (Words_Of (Sender) + 1) / 2 loop
         First := Field_Of (Data, Sender, Number, Echo, 2 * Pair - 1);
         Second :=
           (if 2 * Pair <= Words_Of (Sender)
            then Field_Of (Data, Sender, Number, Echo, 2 * Pair)
            else 0);
         Result (3 * Pair - 1) := Byte (First / 16);
         Result (3 * Pair) :=
           Byte (First mod 16) * 16 + Byte (Second / 256);
         Result (3 * Pair + 1) := Byte (Second mod 256);

         pragma Assert (Field_At (Result, 2 * Pair - 1) = First);
         pragma Assert
           (if 2 * Pair <= Words_Of (Sender)
            then Field_At (Result, 2 * Pair) = Second);
         pragma Loop_Invariant (Result (1) = Result'Loop_Entry (1));
         pragma Loop_Invariant
           (for all Which in Word_Place =>
              (if Which <= 2 * Pair and then Which <= Words_Of (Sender)
               then Field_At (Result, Which) =
                      Field_Of (Data, Sender, Number, Echo, Which)));
      end loop;

      if Sender = Aircraft then
         Result (Before_Counter) := Byte (Code_Of (Echo));
         Result (Before_Counter + 1) := Card_Of (Data);
         for Where in Byte_Index range 2 .. 4 loop
            Result (Before_Counter + Where) := Byte_Of (Number, Where);
            pragma Loop_Invariant
              (for all Before in Byte_Index range 1 .. Before_Counter + 1 =>
                 Result (Before) = Result'Loop_Entry (Before));
            pragma Loop_Invariant
              (for all Done in Before_Counter + 2 .. Before_Counter + Where =>
                 Result (Done) = Byte_Of (Number, Done - Before_Counter));
         end loop;
      end if;
      return Result;
   end Packed;

   function Unpacked
     (Block  : Block_Data;
      Sender : Station) return Block_Words
   is
      Result : Block_Words := [others => 0];
   begin
      for Which in Word_Place range 1 .. Words_Of (Sender) loop
         Result (Which) := Word_In_Format_2 (Block, Sender, Which);

         pragma Loop_Invariant
           (for all Each in Word_Place =>
              Result (Each) =
                (if Each <= Which
                 then Word_In_Format_2 (Block, Sender, Each)
                 else 0));
      end loop;
      return Result;
   end Unpacked;

   --  Each byte by its own number: it needs no shift by a variable.
   function Hello
     (Number   : Key_Number;
      Own      : Nonce;
      Answered : Nonce) return Block_Data
   is
     ([1      => Hello_Mark,
       2      => Byte (Number),
       3      => Byte_Of (Own, 1),
       4      => Byte_Of (Own, 2),
       5      => Byte_Of (Own, 3),
       6      => Byte_Of (Own, 4),
       7      => Byte_Of (Own, 5),
       8      => Byte_Of (Own, 6),
       9      => Byte_Of (Own, 7),
       10     => Byte_Of (Own, 8),
       11     => Byte_Of (Answered, 1),
       12     => Byte_Of (Answered, 2),
       13     => Byte_Of (Answered, 3),
       14     => Byte_Of (Answered, 4),
       15     => Byte_Of (Answered, 5),
       16     => Byte_Of (Answered, 6),
       17     => Byte_Of (Answered, 7),
       18     => Byte_Of (Answered, 8),
       others => 0]);

   --  The whole words that the tag covers, and the bytes after them.
   Uplink_Whole   : constant := Uplink_Covered / 8;
   Uplink_Rest    : constant := Uplink_Covered mod 8;
   Downlink_Whole : constant := Downlink_Covered / 8;
   Downlink_Rest  : constant := Downlink_Covered mod 8;

   --  The whole words are those from 1 on in the message.
   function Whole_Words (Sender : Station) return Word_Number is
     (if Sender = Ground then Uplink_Whole else Downlink_Whole)
   with Global => null;

   function First_Word (Number : Counter; Echo : Counter) return Unsigned_64 is
     (Joined
        (Half_Of
           (Byte_Of (Number, 1), Byte_Of (Number, 2),
            Byte_Of (Number, 3), Byte_Of (Number, 4)),
         Half_Of
           (Byte_Of (Echo, 1), Byte_Of (Echo, 2),
            Byte_Of (Echo, 3), Byte_Of (Echo, 4))))
   with Global => null;

   function Half_At (Block : Block_Data; First : Byte_Index)
                     return Unsigned_32
   is
     (Half_Of
        (Block (First), Block (First + 1), Block (First + 2),
         Block (First + 3)))
   with
     Global => null,
     Pre    => First <= Byte_Index'Last - 3;

   --  The first byte of a word.
   function Place_Of (Which : Word_Number) return Byte_Index is
     (8 * Byte_Index (Which) - 7)
   with
     Global => null,
     Pre    =>
       Which in 1 .. Word_Number'Max
         (Whole_Words (Ground), Whole_Words (Aircraft));

   --  A byte after the whole words, or 0 if the tag covers no more. Whole is
   --  the number of their bytes.
   function Byte_After
     (Block : Block_Data;
      Whole : Byte_Count;
      Rest  : Byte_Count;
      Where : Byte_Number) return Byte
   is
     (if Byte_Count (Where) < Rest then Block (Whole + Byte_Count (Where) + 1)
      else 0)
   with
     Inline,
     Global => null,
     Pre    => Rest < 8 and then Whole <= Byte_Count'Last - Rest;

   --  The last word has those bytes, zeros, and the message's length.
   function Last_Word_Of
     (Block : Block_Data;
      Whole : Byte_Count;
      Rest  : Byte_Count) return Unsigned_64
   is
     (Joined
        (Half_Of
           (Byte_After (Block, Whole, Rest, 0),
            Byte_After (Block, Whole, Rest, 1),
            Byte_After (Block, Whole, Rest, 2),
            Byte_After (Block, Whole, Rest, 3)),
         Half_Of
           (Byte_After (Block, Whole, Rest, 4),
            Byte_After (Block, Whole, Rest, 5),
            Byte_After (Block, Whole, Rest, 6),
            Byte (Whole + Rest) + 8)))
   with
     Inline,
     Global => null,
     Pre    => Rest < 8 and then Whole <= Byte_Count'Last - Rest;

   function Last_Word (Block : Block_Data; Sender : Station)
                       return Unsigned_64
   is
     (if Sender = Ground
      then Last_Word_Of (Block, 8 * Uplink_Whole, Uplink_Rest)
      else Last_Word_Of (Block, 8 * Downlink_Whole, Downlink_Rest))
   with Global => null;

   procedure Prove_Last_Word
     (Block  : Block_Data;
      Sender : Station;
      Number : Counter;
      Echo   : Counter)
   with
     Ghost,
     Global => null,
     Post   =>
       Last_Word (Block, Sender) =
         Word_At
           (Message_Of (Block, Sender, Number, Echo),
            Whole_Words (Sender) + 1);

   procedure Prove_Last_Word
     (Block  : Block_Data;
      Sender : Station;
      Number : Counter;
      Echo   : Counter)
   is
      Covering : constant Message := Message_Of (Block, Sender, Number, Echo);
   begin
      if Sender = Ground then
         pragma Assert
           (for all Where in Byte_Number range 0 .. 6 =>
              Padded (Covering, Uplink_Whole + 1, Where) =
                Byte_After (Block, 8 * Uplink_Whole, Uplink_Rest, Where));
         pragma Assert
           (Padded (Covering, Uplink_Whole + 1, 7) = Uplink_Covered + 8);
         pragma Assert
           (Last_Word (Block, Sender) =
              Word_At (Covering, Uplink_Whole + 1));
      else
         pragma Assert
           (for all Where in Byte_Number range 0 .. 6 =>
              Padded (Covering, Downlink_Whole + 1, Where) =
                Byte_After (Block, 8 * Downlink_Whole, Downlink_Rest, Where));
         pragma Assert
           (Padded (Covering, Downlink_Whole + 1, 7) = Downlink_Covered + 8);
         pragma Assert
           (Last_Word (Block, Sender) =
              Word_At (Covering, Downlink_Whole + 1));
      end if;
   end Prove_Last_Word;

   function Tag_Of
     (Block    : Block_Data;
      Sender   : Station;
      Number   : Counter;
      Echo     : Counter;
      With_Key : Key) return Unsigned_64
   is
      Covering : constant Message := Message_Of (Block, Sender, Number, Echo)
      with Ghost;

      S : State := Initial (With_Key);
   begin
      pragma Assert (First_Word (Number, Echo) = Word_At (Covering, 0));
      Absorb (S, First_Word (Number, Echo));
      for Which in Word_Number range 1 .. Whole_Words (Sender) loop
         pragma Assert
           (Joined
              (Half_At (Block, Place_Of (Which)),
               Half_At (Block, Place_Of (Which) + 4))
              = Word_At (Covering, Which));
         Absorb
           (S,
            Joined
              (Half_At (Block, Place_Of (Which)),
               Half_At (Block, Place_Of (Which) + 4)));
         pragma Loop_Invariant (S = After (Covering, With_Key, Which + 1));
      end loop;
      Prove_Last_Word (Block, Sender, Number, Echo);
      pragma Assert (S = After (Covering, With_Key, Whole_Words (Sender) + 1));
      Absorb (S, Last_Word (Block, Sender));
      pragma Assert (S = After (Covering, With_Key, Whole_Words (Sender) + 2));
      pragma Assert
        (URV.Sip_Hash.Words_Of (Covering) = Whole_Words (Sender) + 2);
      return Last_Tag (S);
   end Tag_Of;

   --  The comparison takes the same time wherever the tag is wrong (SEC-2).
   function Has_Tag
     (Block  : Block_Data;
      Sender : Station;
      Item   : Unsigned_64) return Boolean
   is
      function Difference (Where : Byte_Index) return Byte is
        (Block (Covered (Sender) + Where) xor Tag_Byte (Item, Where))
      with Pre => Where <= Tag_Bytes (Sender);

      Differs : Byte :=
        Difference (1) or Difference (2) or Difference (3)
        or Difference (4) or Difference (5) or Difference (6);
   begin
      if Sender = Aircraft then
         Differs := Differs or Difference (7) or Difference (8);
      end if;
      return Differs = 0;
   end Has_Tag;

end URV.Seal_Blocks;
