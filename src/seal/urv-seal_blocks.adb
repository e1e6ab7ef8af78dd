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

   function Message_Of
     (Block  : Block_Data;
      Sender : Station;
      Number : Counter;
      Echo   : Counter) return Message
   is
      Result : Message :=
        (Length => Message_Length (Covered (Sender)) + 8,
         Bytes  =>
           [1      => Byte_Of (Number, 1),
            2      => Byte_Of (Number, 2),
            3      => Byte_Of (Number, 3),
            4      => Byte_Of (Number, 4),
            5      => Byte_Of (Echo, 1),
            6      => Byte_Of (Echo, 2),
            7      => Byte_Of (Echo, 3),
            8      => Byte_Of (Echo, 4),
            others => 0]);
   begin
      for Where in Byte_Index range 1 .. Covered (Sender) loop
         Result.Bytes (Message_Index (Where) + 8) := Block (Where);

         pragma Loop_Invariant
           (Result.Length = Message_Length (Covered (Sender)) + 8);
         pragma Loop_Invariant
           (for all Each in Message_Index =>
              Result.Bytes (Each) =
                (if Each <= 4 then Byte_Of (Number, Byte_Index (Each))
                 elsif Each <= 8 then Byte_Of (Echo, Byte_Index (Each - 4))
                 elsif Each <= Message_Index (Where) + 8
                 then Block (Byte_Index (Each - 8))
                 else 0));
      end loop;
      return Result;
   end Message_Of;

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
