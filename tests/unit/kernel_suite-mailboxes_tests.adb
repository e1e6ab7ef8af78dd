--  SPDX-License-Identifier: Apache-2.0

with Checks;       use Checks;
with Expect_Value;
with Expectations; use Expectations;
with URVOS;        use URVOS;
with URVOS.Mailboxes;
with URVOS.Shared_Mailboxes;

separate (Kernel_Suite)
package body Mailboxes_Tests is

   --  The tests, in order.
   procedure First_State;
   procedure Receive_Unsent;
   procedure Send_Receive;
   procedure Overwrite;
   procedure Receive_Twice;
   procedure Same_Again;
   procedure Model;
   procedure Two_Tasks;
   procedure Reset;
   procedure Full_Count;

   Neutral : constant Word := 16#800#;

   package Boxes is new URVOS.Mailboxes (Word, Neutral);
   use Boxes;

   procedure Expect is new Expect_Value (Flag);

   --  Expects the whole state of a box.
   procedure Expect_State
     (When_It_Was        : String;
      Box                : Mailbox;
      Data               : Word;
      Producer, Consumer : Flag;
      Missed             : Count);

   --  Receives and expects this outcome.
   procedure Expect_Receive
     (When_It_Was : String;
      Box         : in out Mailbox;
      Data        : Word;
      Fresh       : Boolean);

   --  Sends and expects this outcome.
   procedure Expect_Send
     (When_It_Was : String;
      Box         : in out Mailbox;
      Data        : Word;
      Success     : Boolean);

   --  A message that is long enough to be caught half written, and a box for
   --  it between two tasks.
   type Long_Message is array (1 .. 256) of Count;

   package For_Long is
     new URVOS.Shared_Mailboxes (Long_Message, (others => 0));

   Shared : For_Long.Variable;

   procedure Expect_State
     (When_It_Was        : String;
      Box                : Mailbox;
      Data               : Word;
      Producer, Consumer : Flag;
      Missed             : Count)
   is
   begin
      Expect (When_It_Was & ", contents", Contents (Box), Data);
      Expect (When_It_Was & ", produced", Produced (Box), Producer);
      Expect (When_It_Was & ", consumed", Consumed (Box), Consumer);
      Expect (When_It_Was & ", misses", Misses (Box), Missed);
      Expect
        (When_It_Was & ", is fresh", Is_Fresh (Box), Producer /= Consumer);
   end Expect_State;

   procedure Expect_Receive
     (When_It_Was : String;
      Box         : in out Mailbox;
      Data        : Word;
      Fresh       : Boolean)
   is
      Item     : Word;
      Is_Fresh : Boolean;
   begin
      Receive (Box, Item, Is_Fresh);
      Expect (When_It_Was & ", received", Item, Data);
      Expect (When_It_Was & ", received fresh", Is_Fresh, Fresh);
   end Expect_Receive;

   procedure Expect_Send
     (When_It_Was : String;
      Box         : in out Mailbox;
      Data        : Word;
      Success     : Boolean)
   is
      Succeeded : Boolean;
   begin
      Send (Box, Data, Succeeded);
      Expect (When_It_Was & ", sent with success", Succeeded, Success);
   end Expect_Send;

   procedure First_State is
      Box : constant Mailbox := Empty_Mailbox;

      --  A box that was not initialised.
      Default : Mailbox;
      pragma Warnings (Off, Default, Reason => "its defaults are meant");
   begin
      Expect_State ("empty box", Box, Neutral, 0, 0, 0);
      Expect_State ("default box", Default, Neutral, 0, 0, 0);
   end First_State;

   procedure Receive_Unsent is
      Box : Mailbox := Empty_Mailbox;
   begin
      Expect_Receive ("nothing sent", Box, Neutral, Fresh => False);
      Expect_State ("after that", Box, Neutral, 0, 0, 1);
   end Receive_Unsent;

   procedure Send_Receive is
      Box : Mailbox := Empty_Mailbox;
   begin
      for Number in Word range 1 .. 100 loop
         Expect_Send ("each", Box, Number, Success => True);
         Expect_State
           ("sent", Box, Number, Flag (Number), Flag (Number) - 1, 0);
         Expect_Receive ("each", Box, Number, Fresh => True);
         Expect_State
           ("received", Box, Number, Flag (Number), Flag (Number), 0);
      end loop;
   end Send_Receive;

   procedure Overwrite is
      Box : Mailbox := Empty_Mailbox;
   begin
      Expect_Send ("first", Box, 1, Success => True);
      Expect_Send ("second", Box, 2, Success => False);
      Expect_Send ("third", Box, 3, Success => False);
      Expect_State ("overwritten twice", Box, 3, 1, 0, 0);
      Expect_Receive ("overwritten", Box, 3, Fresh => True);
      Expect_Receive ("the ones before", Box, 3, Fresh => False);
      Expect_Send ("fourth", Box, 4, Success => True);
      Expect_State ("fourth", Box, 4, 2, 1, 1);
   end Overwrite;

   procedure Receive_Twice is
      Box : Mailbox := Empty_Mailbox;
   begin
      Expect_Send ("one", Box, 7, Success => True);
      Expect_Receive ("once", Box, 7, Fresh => True);
      for Times in Count range 1 .. 10 loop
         Expect_Receive ("again", Box, 7, Fresh => False);
         Expect_State ("again", Box, 7, 1, 1, Times);
      end loop;
      Expect_Send ("next", Box, 8, Success => True);
      Expect_Receive ("next", Box, 8, Fresh => True);
      Expect_State ("misses stay counted", Box, 8, 2, 2, 10);
   end Receive_Twice;

   procedure Same_Again is
      Box : Mailbox := Empty_Mailbox;
   begin
      --  Freshness belongs to the message, not to its value.
      Expect_Send ("neutral", Box, Neutral, Success => True);
      Expect_Receive ("neutral", Box, Neutral, Fresh => True);
      Expect_Send ("the same", Box, Neutral, Success => True);
      Expect_Receive ("the same", Box, Neutral, Fresh => True);
   end Same_Again;

   procedure Model is
      Box : Mailbox := Empty_Mailbox;

      --  The expected next events of the box.
      Last       : Word    := Neutral;
      Waiting    : Boolean := False;
      Sent, Came : Flag    := 0;
      Missed     : Count   := 0;

      --  A fixed, pseudo-random series of sends and receives.
      Random : Flag := 1;
   begin
      for Step in 1 .. 20_000 loop
         Random := Random * 1_664_525 + 1_013_904_223;
         if Random / 2 ** 24 < 128 then
            Last := Word (Random mod 2 ** 16);
            Expect_Send ("step" & Step'Image, Box, Last, not Waiting);
            Sent    := Sent + (if Waiting then 0 else 1);
            Waiting := True;
         else
            Expect_Receive ("step" & Step'Image, Box, Last, Waiting);
            Came    := Came + (if Waiting then 1 else 0);
            Missed  := Missed + (if Waiting then 0 else 1);
            Waiting := False;
         end if;
         Expect_State ("step" & Step'Image, Box, Last, Sent, Came, Missed);
      end loop;
   end Model;

   procedure Two_Tasks is
      Sends : constant Count := 100_000;

      task Producer;

      task body Producer is
         Success : Boolean;
      begin
         for Number in 1 .. Sends loop
            Shared.Send ((others => Number), Success);
         end loop;
      end Producer;

      Item      : Long_Message;
      Fresh     : Boolean;
      Last      : Count := 0;
      Fresh_Now : Count := 0;
      Box       : For_Long.Boxes.Mailbox;
      Is_Over   : Boolean := False;
   begin
      --  One more look after the producer has ended.
      while not Is_Over loop
         Is_Over := Producer'Terminated;
         Shared.Receive (Item, Fresh);
         for Part of Item loop
            Expect ("a part of the message", Part, Item (Item'First));
         end loop;
         if Fresh then
            Fresh_Now := Fresh_Now + 1;
            Expect
              ("fresh and newer than before", Item (Item'First) > Last, True);
         else
            Expect ("old and as before", Item (Item'First), Last);
         end if;
         Last := Item (Item'First);
      end loop;
      Expect ("the last message", Last, Sends);

      Box := Shared.Snapshot;
      Expect
        ("messages seen fresh and messages consumed", Fresh_Now,
         Count (For_Long.Boxes.Consumed (Box)));
      Expect
        ("produced and consumed, at the end",
         Count (For_Long.Boxes.Produced (Box)),
         Count (For_Long.Boxes.Consumed (Box)));
   end Two_Tasks;

   procedure Reset is
      Box     : For_Long.Boxes.Mailbox;
      Item    : Long_Message;
      Fresh   : Boolean;
      Success : Boolean;
   begin
      Shared.Send ((others => 8), Success);
      Expect ("the first send replaces nothing", Success, True);
      Shared.Send ((others => 9), Success);
      Expect ("the second send replaces the first", Success, False);
      Shared.Reset;
      Box := Shared.Snapshot;
      Expect ("produced", Count (For_Long.Boxes.Produced (Box)), 0);
      Expect ("consumed", Count (For_Long.Boxes.Consumed (Box)), 0);
      Expect ("misses", For_Long.Boxes.Misses (Box), 0);
      Shared.Receive (Item, Fresh);
      Expect ("fresh after reset", Fresh, False);
      Expect ("data after reset", Item (1), 0);
   end Reset;

   procedure Full_Count is
   begin
      Expect ("one more", Incremented (Count'(41)), 42);
      Expect ("the last one", Incremented (Count'Last - 1), Count'Last);
      Expect ("no more", Incremented (Count'Last), Count'Last);
   end Full_Count;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "INI-8 a new box holds its neutral message, nothing counted",
         First_State'Access);
      Add
        (Suite, "MBX-1 MBX-2 each message is counted once, each way",
         Send_Receive'Access);
      Add
        (Suite, "MBX-2 D-21 an overwritten message is reported",
         Overwrite'Access);
      Add
        (Suite, "MBX-3 MBX-5 before the first message, receiving misses",
         Receive_Unsent'Access);
      Add
        (Suite, "MBX-3 a message is fresh once, then old and a miss",
         Receive_Twice'Access);
      Add
        (Suite, "MBX-3 an equal message is fresh all the same",
         Same_Again'Access);
      Add
        (Suite, "MBX-4 20,000 mixed sends and receives are as modelled",
         Model'Access);
      Add
        (Suite, "MBX-4 between two tasks messages stay whole and in order",
         Two_Tasks'Access);
      Add (Suite, "INI-8 a reset box is as new", Reset'Access);
      Add
        (Suite, "MBX-1 a count stays at its last value",
         Full_Count'Access);
   end Add_To;

end Mailboxes_Tests;
