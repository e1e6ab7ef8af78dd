--  SPDX-License-Identifier: Apache-2.0

with URVOS;
with URV.Card_Blocks;
with URV.Configurations;
with URV.Recorder_Blocks;
with URV.Type_Codes; use URV.Type_Codes;

package body Partitions.Order_Packets is

   use type Number;

   Magic   : constant := 16#5552_564F#;
   Version : constant := 1;

   --  The positions of the fields.
   Magic_At    : constant := 1;
   Version_At  : constant := 5;
   Length_At   : constant := 7;
   Run_At      : constant := 9;
   Sequence_At : constant := 13;
   Time_At     : constant := 17;
   Kind_At     : constant := 25;
   Items_At    : constant := 27;

   function Is_Meant (Source : Octet_Array) return Boolean is
     (Source'Length >= 4
      and then Value_At (Source, Source'First, 4) = Magic);

   --  The items of a configuration, if they are in range.
   procedure Read_Configuration
     (Bytes    : Octet_Array;
      Block    : out Uplink_Buffer;
      Is_Valid : out Boolean)
   with
     Pre => Bytes'First = 1 and then Bytes'Last = Configuration_Length;

   --  The words of a card's block, or of a request's, if their sum is right.
   procedure Read_Words
     (Bytes    : Octet_Array;
      Block    : out Uplink_Buffer;
      Is_Valid : out Boolean)
   with
     Pre => Bytes'First = 1 and then Bytes'Last = Card_Length;

   procedure Read_Configuration
     (Bytes    : Octet_Array;
      Block    : out Uplink_Buffer;
      Is_Valid : out Boolean)
   is
      use URV.Configurations;

      Item  : Configuration := (others => 0);
      Place : Positive := Items_At;
      Value : Number;
   begin
      Is_Valid :=
        Value_At (Bytes, Kind_At, 2) = Number (Configuration_Kind);
      for Each of Item loop
         Value := Value_At (Bytes, Place, 2);
         Is_Valid := Is_Valid and then Value <= Number (Field'Last);
         Each := Field (Value mod (Number (Field'Last) + 1));
         Place := Place + 2;
      end loop;
      Is_Valid := Is_Valid and then Item (Serial) in Serial_Number;
      Block := (if Is_Valid then Block_Of (Item) else Neutral_Uplink);
   end Read_Configuration;

   procedure Read_Words
     (Bytes    : Octet_Array;
      Block    : out Uplink_Buffer;
      Is_Valid : out Boolean)
   is
      subtype Card_Words is Command_Item range Pitch .. Switch_8;

      Place : Positive := Items_At;
   begin
      Block := Neutral_Uplink;
      Block (Roll) := URVOS.Word (Value_At (Bytes, Kind_At, 2));
      Block (Error_Status) := Other_Kind;
      for Item in Card_Words loop
         Block (Item) := URVOS.Word (Value_At (Bytes, Place, 2));
         Place := Place + 2;
      end loop;
      Is_Valid :=
        URV.Card_Blocks.Is_Whole (Block)
        or else URV.Recorder_Blocks.Is_Whole (Block);
   end Read_Words;

   procedure Read
     (Source   : Octet_Array;
      Item     : out Packet;
      Is_Valid : out Boolean)
   is
      --  From 1 on, so that the places fit.
      Bytes : constant Octet_Array (1 .. Source'Length) := Source;
   begin
      Item := (others => <>);
      case Bytes'Last is
         when Configuration_Length =>
            Read_Configuration (Bytes, Item.Block, Is_Valid);
         when Card_Length =>
            Read_Words (Bytes, Item.Block, Is_Valid);
         when others =>
            Is_Valid := False;
            return;
      end case;
      Is_Valid :=
        Is_Valid
        and then Value_At (Bytes, Magic_At, 4) = Magic
        and then Value_At (Bytes, Version_At, 2) = Version
        and then Value_At (Bytes, Length_At, 2) = Number (Bytes'Last);
      Item.Run      := Value_At (Bytes, Run_At, 4);
      Item.Sequence := Value_At (Bytes, Sequence_At, 4);
      Item.Made_At  := Value_At (Bytes, Time_At, 8);
   end Read;

end Partitions.Order_Packets;
