--  SPDX-License-Identifier: Apache-2.0

with AUnit.Assertions; use AUnit.Assertions;

with Checks;              use Checks;
with Expect_Value;
with Expectations;        use Expectations;
with URVOS;               use URVOS;
with Telemetry;           use Telemetry;
with Telemetry.Checksum;
with Telemetry.Headers;   use Telemetry.Headers;
with Telemetry.Memory;    use Telemetry.Memory;
with Telemetry.Receivers; use Telemetry.Receivers;

package body Receivers_Tests is

   --  The tests, in order.
   procedure Good_Message;
   procedure Wrong_Checksum;
   procedure Parities;
   procedure One_More;
   procedure Single_Bytes;
   procedure Deaf_Out_Of_Step;
   procedure Interrupted;
   procedure Untouched;

   Length : constant Block_Length := Uplink_Length;

   Header_Byte : constant Byte := Data_Header (Length);

   procedure Expect is new Expect_Value (Event_Kind);
   procedure Expect is new Expect_Value (Slot);
   procedure Expect is new Expect_Value (Receiver_State);

   --  A receiver, its buffers, and what came out last.
   type Half is record
      Receiver : Receivers.Receiver;
      Pair     : Buffer_Pair;
      Outcome  : Event;
   end record;

   --  One character.
   procedure Hear
     (Item         : in out Half;
      Data         : Byte;
      Parity_Error : Boolean := False;
      Wants_Data   : Boolean := True);

   --  The board has waited at the end of the message.
   procedure Judge (Item : in out Half);

   --  The board gives up what was coming in.
   procedure Restart (Item : in out Half);

   --  A whole data message whose bytes are Mark, with this added to its
   --  checksum, and a parity error in the Bad_Parity-th character.
   procedure Hear_Message
     (Item       : in out Half;
      Mark       : Byte;
      Wrong      : Byte    := 0;
      Bad_Parity : Natural := 0);

   procedure Hear
     (Item         : in out Half;
      Data         : Byte;
      Parity_Error : Boolean := False;
      Wants_Data   : Boolean := True) is
   begin
      Accept_Character
        (Item.Receiver, Item.Pair, Length, Wants_Data, Data, Parity_Error,
         Item.Outcome);
   end Hear;

   procedure Hear_Message
     (Item       : in out Half;
      Mark       : Byte;
      Wrong      : Byte    := 0;
      Bad_Parity : Natural := 0)
   is
      Sum : Byte := Checksum.Next (Checksum.First_Value, Header_Byte);
   begin
      Hear (Item, Header_Byte, Bad_Parity = 1);
      for Place in 2 .. Natural (Length) + 1 loop
         Hear (Item, Mark, Bad_Parity = Place);
         Sum := Checksum.Next (Sum, Mark);
      end loop;
      Hear (Item, Sum + Wrong, Bad_Parity = Natural (Length) + 2);
   end Hear_Message;

   procedure Judge (Item : in out Half) is
   begin
      Expect ("at the end", Item.Receiver.State, At_End);
      Item.Pair := Pair_Judged (Item.Receiver, Item.Pair);
      Item.Receiver.State := At_Start;
   end Judge;

   procedure Restart (Item : in out Half) is
   begin
      Item.Receiver.State := At_Start;
      Item.Pair := Released (Item.Pair);
   end Restart;

   procedure Good_Message is
      Item : Half;
      Sum  : Byte := Checksum.Next (Checksum.First_Value, Header_Byte);
   begin
      Hear (Item, Header_Byte);
      Expect ("header", Item.Outcome.Kind, Block_Begun);
      for Value in Byte range 1 .. Byte (Length) loop
         Hear (Item, Value);
         Sum := Checksum.Next (Sum, Value);
         Expect ("data", Item.Outcome.Kind, Nothing);
         Expect ("full before the checksum", Any_Full (Item.Pair), False);
         Expect
           ("busy meanwhile", Item.Pair.Slots (Item.Receiver.Target).Busy,
            True);
      end loop;
      Hear (Item, Sum);
      Expect ("checksum", Item.Outcome.Kind, Block_Whole);
      Expect ("full before it is judged", Any_Full (Item.Pair), False);
      Judge (Item);
      Expect ("full after", Item.Pair.Slots (Item.Receiver.Target).Full, True);
      Expect
        ("busy after", Item.Pair.Slots (Item.Receiver.Target).Busy, False);
      Expect ("newest", Item.Pair.Newest, Item.Receiver.Target);
      for I in 1 .. Length loop
         Expect
           ("byte" & I'Image, Item.Pair.Slots (Item.Pair.Newest).Data (I),
            Byte (I));
      end loop;
   end Good_Message;

   procedure Wrong_Checksum is
      Item : Half;
   begin
      for Wrong in Byte range 1 .. 255 loop
         Hear_Message (Item, 7, Wrong => Wrong);
         Expect ("wrong by" & Wrong'Image, Item.Outcome.Kind, Block_Spoilt);
         Judge (Item);
         Expect ("full", Any_Full (Item.Pair), False);
      end loop;
      Hear_Message (Item, 8);
      Expect ("the next", Item.Outcome.Kind, Block_Whole);
      Judge (Item);
      Expect ("full after the next", Any_Full (Item.Pair), True);
   end Wrong_Checksum;

   procedure Parities is
      Item : Half;
   begin
      for Place in 2 .. Natural (Length) + 2 loop
         Hear_Message (Item, 7, Bad_Parity => Place);
         Expect
           ("parity error at" & Place'Image, Item.Outcome.Kind, Block_Spoilt);
         Judge (Item);
         Expect ("full", Any_Full (Item.Pair), False);
      end loop;
      Hear_Message (Item, 8);
      Expect ("the next", Item.Outcome.Kind, Block_Whole);
      Judge (Item);

      --  In the header it leaves the receiver out of step.
      Hear (Item, Header_Byte, Parity_Error => True);
      Expect ("header", Item.Outcome.Kind, Lost_Step);
   end Parities;

   procedure Single_Bytes is
      Item     : Half;
      Expected : Event_Kind;
   begin
      for Value in Byte loop
         for Wants_Data in Boolean loop
            Item := (others => <>);
            Hear (Item, Value, Wants_Data => Wants_Data);
            Expected :=
              (if not Is_Valid (Value) then Lost_Step
               elsif Value = Encode ((Kind => Command_To_Downlink))
               then Command
               elsif Value = Header_Byte and Wants_Data then Block_Begun
               elsif Decode (Value).Kind = Data then Lost_Step
               else Status);
            Expect ("byte" & Value'Image, Item.Outcome.Kind, Expected);
            if Expected = Status then
               Expect ("good", Item.Outcome.Good, Decode (Value).Good);
               Expect
                 ("wants downlink", Item.Outcome.Wants_Downlink,
                  Decode (Value).Wants_Downlink);
            end if;
         end loop;
      end loop;
   end Single_Bytes;

   procedure One_More is
      Item : Half;
   begin
      --  Whatever comes after the end, and however much.
      for More in 1 .. 3 loop
         for Value in Byte loop
            Item := (others => <>);
            Hear_Message (Item, 7);
            Expect ("whole", Item.Outcome.Kind, Block_Whole);
            for Count in 1 .. More loop
               Hear (Item, Value);
               Expect ("one more", Item.Outcome.Kind, Block_Spoilt);
            end loop;
            Judge (Item);
            Expect ("full", Any_Full (Item.Pair), False);
            Hear_Message (Item, 8);
            Expect ("the next", Item.Outcome.Kind, Block_Whole);
         end loop;
      end loop;
   end One_More;

   procedure Deaf_Out_Of_Step is
      Item   : Half;
      Before : Half;
   begin
      Hear (Item, 0);
      Expect ("state", Item.Receiver.State, Out_Of_Step);
      Before := Item;
      for Value in Byte loop
         Hear (Item, Value);
         Expect ("byte" & Value'Image, Item.Outcome.Kind, Nothing);
         Assert
           (Item.Receiver = Before.Receiver and then Item.Pair = Before.Pair,
            "byte" & Value'Image & " changed something, expected nothing");
      end loop;
      Restart (Item);
      Hear_Message (Item, 9);
      Expect ("after a restart", Item.Outcome.Kind, Block_Whole);
   end Deaf_Out_Of_Step;

   procedure Interrupted is
      Item : Half;
   begin
      --  A message breaks off after any number of characters.
      for Characters in 0 .. Natural (Length) loop
         Item := (others => <>);
         Hear_Message (Item, 1);
         Judge (Item);
         Hear (Item, Header_Byte);
         for Count in 1 .. Characters loop
            Hear (Item, 2);
         end loop;
         Restart (Item);
         Expect ("first busy", Item.Pair.Slots (First).Busy, False);
         Expect ("second busy", Item.Pair.Slots (Second).Busy, False);
         Expect ("the block before is there", Any_Full (Item.Pair), True);
         Expect ("and whole", Contents (Item.Pair) (Length), 1);
         Item.Pair := Taken (Item.Pair);
         Hear_Message (Item, 3);
         Expect ("the next message", Item.Outcome.Kind, Block_Whole);
      end loop;
   end Interrupted;

   procedure Untouched is
      Item   : Half;
      Target : Slot;
   begin
      --  Nobody takes anything: the newest good block is there all the
      --  same, and the buffer that is being filled is the other one.
      for Mark in Byte range 1 .. 20 loop
         Hear_Message (Item, Mark);
         Judge (Item);
         Target := Item.Receiver.Target;
         Hear (Item, Header_Byte);
         Expect
           ("the next goes elsewhere", Item.Receiver.Target = Target, False);
         Restart (Item);
      end loop;
      Expect ("fresh", Any_Full (Item.Pair), True);
      Expect ("the newest", Contents (Item.Pair) (1), 20);
   end Untouched;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "LNK-5 a buffer is full only after the checksum matched",
         Good_Message'Access);
      Add
        (Suite, "LNK-5 any wrong checksum leaves the buffers not full",
         Wrong_Checksum'Access);
      Add
        (Suite, "LNK-5 a parity error anywhere spoils the message",
         Parities'Access);
      Add
        (Suite, "LNK-5 D-27 a message that goes on is never taken",
         One_More'Access);
      Add
        (Suite, "LNK-3 a first byte means what its message is",
         Single_Bytes'Access);
      Add
        (Suite, "LNK-9 out of step nothing is heard until the restart",
         Deaf_Out_Of_Step'Access);
      Add
        (Suite, "LNK-9 a message that breaks off spoils no other",
         Interrupted'Access);
      Add
        (Suite, "LNK-4 with nobody taking, the newest block stays whole",
         Untouched'Access);
   end Add_To;

end Receivers_Tests;
