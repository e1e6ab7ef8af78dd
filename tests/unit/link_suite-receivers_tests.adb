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

separate (Link_Suite)
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

   --  A receiver, its buffers, and its last event.
   type Half is record
      Receiver : Receivers.Receiver;
      Pair     : Buffer_Pair;
      Outcome  : Event;
   end record;

   --  Receives one character.
   procedure Hear
     (This         : in out Half;
      Data         : Byte;
      Parity_Error : Boolean := False;
      Wants_Data   : Boolean := True);

   --  The board has waited at the end of the message.
   procedure Judge (This : in out Half);

   --  The board abandons the message under reception.
   procedure Restart (This : in out Half);

   --  Receives a data message whose bytes are Mark, with this value added to
   --  its checksum, and a parity error in character number Bad_Parity.
   procedure Hear_Message
     (This       : in out Half;
      Mark       : Byte;
      Wrong      : Byte    := 0;
      Bad_Parity : Natural := 0);

   procedure Hear
     (This         : in out Half;
      Data         : Byte;
      Parity_Error : Boolean := False;
      Wants_Data   : Boolean := True) is
   begin
      Accept_Character
        (This.Receiver, This.Pair, Length, Wants_Data, Data, Parity_Error,
         This.Outcome);
   end Hear;

   procedure Hear_Message
     (This       : in out Half;
      Mark       : Byte;
      Wrong      : Byte    := 0;
      Bad_Parity : Natural := 0)
   is
      Sum : Byte := Checksum.Next (Checksum.First_Value, Header_Byte);
   begin
      Hear (This, Header_Byte, Bad_Parity = 1);
      for Place in 2 .. Natural (Length) + 1 loop
         Hear (This, Mark, Bad_Parity = Place);
         Sum := Checksum.Next (Sum, Mark);
      end loop;
      Hear (This, Sum + Wrong, Bad_Parity = Natural (Length) + 2);
   end Hear_Message;

   procedure Judge (This : in out Half) is
   begin
      Expect ("at the end", This.Receiver.State, At_End);
      This.Pair := Pair_Judged (This.Receiver, This.Pair);
      This.Receiver.State := At_Start;
   end Judge;

   procedure Restart (This : in out Half) is
   begin
      This.Receiver.State := At_Start;
      This.Pair := Released (This.Pair);
   end Restart;

   procedure Good_Message is
      This : Half;
      Sum  : Byte := Checksum.Next (Checksum.First_Value, Header_Byte);
   begin
      Hear (This, Header_Byte);
      Expect ("header", This.Outcome.Kind, Block_Begun);
      for Value in Byte range 1 .. Byte (Length) loop
         Hear (This, Value);
         Sum := Checksum.Next (Sum, Value);
         Expect ("data", This.Outcome.Kind, Nothing);
         Expect ("full before the checksum", Any_Full (This.Pair), False);
         Expect
           ("busy meanwhile", This.Pair.Slots (This.Receiver.Target).Busy,
            True);
      end loop;
      Hear (This, Sum);
      Expect ("checksum", This.Outcome.Kind, Block_Whole);
      Expect ("full before it is judged", Any_Full (This.Pair), False);
      Judge (This);
      Expect ("full after", This.Pair.Slots (This.Receiver.Target).Full, True);
      Expect
        ("busy after", This.Pair.Slots (This.Receiver.Target).Busy, False);
      Expect ("newest", This.Pair.Newest, This.Receiver.Target);
      for I in 1 .. Length loop
         Expect
           ("byte" & I'Image, This.Pair.Slots (This.Pair.Newest).Data (I),
            Byte (I));
      end loop;
   end Good_Message;

   procedure Wrong_Checksum is
      This : Half;
   begin
      for Wrong in Byte range 1 .. 255 loop
         Hear_Message (This, 7, Wrong => Wrong);
         Expect ("wrong by" & Wrong'Image, This.Outcome.Kind, Block_Spoilt);
         Judge (This);
         Expect ("full", Any_Full (This.Pair), False);
      end loop;
      Hear_Message (This, 8);
      Expect ("the next", This.Outcome.Kind, Block_Whole);
      Judge (This);
      Expect ("full after the next", Any_Full (This.Pair), True);
   end Wrong_Checksum;

   procedure Parities is
      This : Half;
   begin
      for Place in 2 .. Natural (Length) + 2 loop
         Hear_Message (This, 7, Bad_Parity => Place);
         Expect
           ("parity error at" & Place'Image, This.Outcome.Kind, Block_Spoilt);
         Judge (This);
         Expect ("full", Any_Full (This.Pair), False);
      end loop;
      Hear_Message (This, 8);
      Expect ("the next", This.Outcome.Kind, Block_Whole);
      Judge (This);

      --  A parity error in the header leaves the receiver out of step.
      Hear (This, Header_Byte, Parity_Error => True);
      Expect ("header", This.Outcome.Kind, Lost_Step);
   end Parities;

   procedure Single_Bytes is
      This     : Half;
      Expected : Event_Kind;
   begin
      for Value in Byte loop
         for Wants_Data in Boolean loop
            This := (others => <>);
            Hear (This, Value, Wants_Data => Wants_Data);
            Expected :=
              (if not Is_Valid (Value) then Lost_Step
               elsif Value = Encode ((Kind => Command_To_Downlink))
               then Command
               elsif Value = Header_Byte and Wants_Data then Block_Begun
               elsif Decode (Value).Kind = Data then Lost_Step
               else Status);
            Expect ("byte" & Value'Image, This.Outcome.Kind, Expected);
            if Expected = Status then
               Expect ("good", This.Outcome.Good, Decode (Value).Good);
               Expect
                 ("wants downlink", This.Outcome.Wants_Downlink,
                  Decode (Value).Wants_Downlink);
            end if;
         end loop;
      end loop;
   end Single_Bytes;

   procedure One_More is
      This : Half;
   begin
      --  For any characters after the end, and any number of them.
      for More in 1 .. 3 loop
         for Value in Byte loop
            This := (others => <>);
            Hear_Message (This, 7);
            Expect ("whole", This.Outcome.Kind, Block_Whole);
            for Count in 1 .. More loop
               Hear (This, Value);
               Expect ("one more", This.Outcome.Kind, Block_Spoilt);
            end loop;
            Judge (This);
            Expect ("full", Any_Full (This.Pair), False);
            Hear_Message (This, 8);
            Expect ("the next", This.Outcome.Kind, Block_Whole);
         end loop;
      end loop;
   end One_More;

   procedure Deaf_Out_Of_Step is
      This   : Half;
      Before : Half;
   begin
      Hear (This, 0);
      Expect ("state", This.Receiver.State, Out_Of_Step);
      Before := This;
      for Value in Byte loop
         Hear (This, Value);
         Expect ("byte" & Value'Image, This.Outcome.Kind, Nothing);
         Assert
           (This.Receiver = Before.Receiver and then This.Pair = Before.Pair,
            "byte" & Value'Image & " changed something, expected nothing");
      end loop;
      Restart (This);
      Hear_Message (This, 9);
      Expect ("after a restart", This.Outcome.Kind, Block_Whole);
   end Deaf_Out_Of_Step;

   procedure Interrupted is
      This : Half;
   begin
      --  A message breaks off after any number of characters.
      for Characters in 0 .. Natural (Length) loop
         This := (others => <>);
         Hear_Message (This, 1);
         Judge (This);
         Hear (This, Header_Byte);
         for Count in 1 .. Characters loop
            Hear (This, 2);
         end loop;
         Restart (This);
         Expect ("first busy", This.Pair.Slots (First).Busy, False);
         Expect ("second busy", This.Pair.Slots (Second).Busy, False);
         Expect ("the block before is there", Any_Full (This.Pair), True);
         Expect ("and whole", Contents (This.Pair) (Length), 1);
         This.Pair := Taken (This.Pair);
         Hear_Message (This, 3);
         Expect ("the next message", This.Outcome.Kind, Block_Whole);
      end loop;
   end Interrupted;

   procedure Untouched is
      This   : Half;
      Target : Slot;
   begin
      --  No controller takes a block: the newest good block remains available,
      --  and the buffer being filled is the other one.
      for Mark in Byte range 1 .. 20 loop
         Hear_Message (This, Mark);
         Judge (This);
         Target := This.Receiver.Target;
         Hear (This, Header_Byte);
         Expect
           ("the next goes elsewhere", This.Receiver.Target = Target, False);
         Restart (This);
      end loop;
      Expect ("fresh", Any_Full (This.Pair), True);
      Expect ("the newest", Contents (This.Pair) (1), 20);
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
        (Suite, "LNK-3 a first byte gives the kind of its message",
         Single_Bytes'Access);
      Add
        (Suite, "LNK-9 out of step nothing is heard until the restart",
         Deaf_Out_Of_Step'Access);
      Add
        (Suite, "LNK-9 a message that breaks off spoils no other",
         Interrupted'Access);
      Add
        (Suite, "LNK-4 without a reader, the newest block stays whole",
         Untouched'Access);
   end Add_To;

end Receivers_Tests;
