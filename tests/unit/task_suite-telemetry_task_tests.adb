--  SPDX-License-Identifier: Apache-2.0

with Checks;        use Checks;
with Expectations;  use Expectations;
with Published_Tags;
with Task_Rig;      use Task_Rig;
with Telemetry;     use Telemetry;
with Telemetry.Checksum;
with Telemetry.Receivers;
with Telemetry.Shared_Boards;
with URVOS;         use URVOS;
with URVOS.Frames;  use URVOS.Frames;
with URV.Buffers;   use URV.Buffers;
with Plain_Messages;
with URV.Codecs;
with URV.Errors;    use URV.Errors;
with URV.Handshakes; use URV.Handshakes;
with URV.Mailboxes; use URV.Mailboxes;
with URV.Plain_Blocks; use URV.Plain_Blocks;
with URV.Routing;   use URV.Routing;
with URV.Seal_Blocks;
with URV.Sessions;
with URV.Shared_Errors;
with URV.Shared_Seals;
with URV.TELIN_Task;
with URV.TELOUT_Task;
with URV.Uplink_Input;

separate (Task_Suite)
package body Telemetry_Task_Tests is

   --  The tests, in order.
   procedure Before_The_First;
   procedure New_Block;
   procedure Block_Again;
   procedure Not_Consumed;
   procedure Cold_Again;
   procedure Refused_Is_Missed;
   procedure Age_Of_This_Frame;
   procedure New_Output;
   procedure No_Output_Now;
   procedure No_Buffer;

   --  The tasks' surroundings. The ground's board sends whenever it has a
   --  block, whatever the block's length.

   Board_In : Telemetry.Shared_Boards.Shared_Board
     (Role            => Aircraft,
      Transmit_Length => URV.Codecs.Downlink.Block_Length,
      Receive_Length  => URV.Codecs.Uplink.Block_Length);

   Board_Out : Telemetry.Shared_Boards.Shared_Board
     (Role            => Ground,
      Transmit_Length => URV.Codecs.Downlink.Block_Length,
      Receive_Length  => URV.Codecs.Uplink.Block_Length);

   Input  : For_Uplink.Variable;
   Output : For_Downlink.Variable;

   Errors : URV.Shared_Errors.Shared_Log;

   Sealing_In  : URV.Shared_Seals.Shared_Seal (Aircraft);
   Sealing_Out : URV.Shared_Seals.Shared_Seal (Aircraft);

   package TELIN is new URV.TELIN_Task
     (Steps           => URV.Uplink_Input,
      Messages        => For_Uplink,
      Telemetry_Board => Board_In,
      TELIN_Variable  => Input,
      Sealing         => Sealing_In,
      Errors          => Errors);

   package TELOUT is new URV.TELOUT_Task
     (Messages        => For_Downlink,
      TELOUT_Variable => Output,
      Telemetry_Board => Board_Out,
      Sealing         => Sealing_Out,
      Errors          => Errors,
      Words_Of        => URV.Codecs.Downlink.Words_Of);

   --  A whole block arrives at the board.
   procedure Receive_Block (Item : Uplink_Buffer);
   procedure Receive_Data (Data : Block_Data);

   --  Runs a frame of TELIN and expects this Is_New.
   procedure Run_TELIN
     (What : String; Is_New : Boolean; Now : Clock_Tick := 0);

   --  TELOUT's board begins to send this block, and then waits for an answer.
   procedure Expect_Block (What : String; Expected : Downlink_Buffer);

   --  TELOUT's board has nothing to send.
   procedure Expect_No_Block (What : String);

   --  Restarts the board and ends its idle time.
   procedure Prepare_Board_Out;

   procedure Receive_Block (Item : Uplink_Buffer) is
   begin
      Receive_Data (Plain_Messages.Block_Of (Item));
   end Receive_Block;

   procedure Receive_Data (Data : Block_Data) is
      Length : constant Byte_Count := URV.Codecs.Uplink.Block_Length;
      Header : constant Byte := Receivers.Data_Header (Length);

      procedure Hear (Value : Byte);

      procedure Hear (Value : Byte) is
         Unused : Boolean;
      begin
         Board_In.Accept_Character (1, Value, False, Unused);
      end Hear;

      Status      : Byte;
      Unused_Send : Boolean;
      Unused_Time : Character_Times;
   begin
      Hear (Header);
      for Place in 1 .. Length loop
         Hear (Data (Place));
      end loop;
      Hear (Checksum.Of_Message (Header, Data, Length));

      --  After the guard time it answers, and the line is free again.
      Board_In.Next_Character
        (Telemetry.Guard_Time, Unused_Send, Status, Unused_Time);
      Board_In.Next_Character (1, Unused_Send, Status, Unused_Time);
   end Receive_Data;

   procedure Prepare_Board_Out is
      Send        : Boolean;
      Unused_Data : Byte;
      Unused_Time : Character_Times;
   begin
      Board_Out.Clear_Transmit_Half;
      Board_Out.Start;
      Board_Out.Next_Character (100, Send, Unused_Data, Unused_Time);
      Expect ("nothing to send to begin with", Send, False);
   end Prepare_Board_Out;

   procedure Expect_Block (What : String; Expected : Downlink_Buffer) is
      Length      : constant Byte_Count := URV.Codecs.Downlink.Block_Length;
      Block       : Block_Data := (others => 0);
      Send        : Boolean;
      Data        : Byte;
      Unused_Time : Character_Times;
   begin
      for Place in 0 .. Length + 1 loop
         Board_Out.Next_Character (1, Send, Data, Unused_Time);
         Expect (What & ", character" & Place'Image, Send, True);
         if Place in 1 .. Length then
            Block (Place) := Data;
         end if;
      end loop;
      Expect_Buffer (What, Plain_Messages.Downlink_In (Block), Expected);
   end Expect_Block;

   procedure Expect_No_Block (What : String) is
      Send        : Boolean;
      Unused_Data : Byte;
      Unused_Time : Character_Times;
   begin
      Board_Out.Next_Character (1, Send, Unused_Data, Unused_Time);
      Expect (What, Send, False);
   end Expect_No_Block;

   procedure Run_TELIN
     (What : String; Is_New : Boolean; Now : Clock_Tick := 0)
   is
      Found : Boolean;
   begin
      TELIN.Run_Transaction (Now, Found);
      Expect (What & ", is new", Found, Is_New);
   end Run_TELIN;

   procedure Before_The_First is
   begin
      Board_In.Start;
      Input.Reset;
      Errors.Clear;
      TELIN.Initialise;
      for Frame in 1 .. 5 loop
         Run_TELIN ("before the first", Is_New => False);
      end loop;
      Up.Expect_Counts ("nothing sent", Input, 0, 0);
      Expect_Errors ("before the first message", Errors, None);
   end Before_The_First;

   procedure New_Block is
   begin
      Before_The_First;
      Receive_Block (Uplink_Of (16#100#));
      Run_TELIN ("a new block", Is_New => True);
      Up.Expect_Counts ("sent", Input, 1, 0);
      Expect_Buffer
        ("message", Up.Taken ("message", Input), Uplink_Of (16#100#));
      Expect_Errors ("a new block", Errors, None);
   end New_Block;

   procedure Block_Again is
   begin
      New_Block;
      for Frame in 1 .. 3 loop
         Run_TELIN ("nothing new", Is_New => False);
         Up.Expect_Counts ("sent", Input, 1 + Count (Frame), Count (Frame));
         Expect_Buffer
           ("previous", Up.Taken ("previous", Input),
            As_Old (Uplink_Of (16#100#)));
         Expect_Errors ("nothing new", Errors, (1 => TELIN_No_Block));
      end loop;

      Receive_Block (Uplink_Of (16#200#));
      Run_TELIN ("the next", Is_New => True);
      Expect_Buffer
        ("the next", Up.Taken ("the next", Input), Uplink_Of (16#200#));
      Expect_Errors ("the next", Errors, None);

      --  A message that the ground marked as old is not new.
      Receive_Block (As_Old (Uplink_Of (16#300#)));
      Run_TELIN ("marked by the ground", Is_New => False);
      Expect_Buffer
        ("marked by the ground", Up.Taken ("marked", Input),
         As_Old (Uplink_Of (16#300#)));
      Expect_Errors ("marked by the ground", Errors, None);
   end Block_Again;

   procedure Not_Consumed is
   begin
      New_Block;
      Receive_Block (Uplink_Of (16#200#));
      Run_TELIN ("new", Is_New => True);
      Expect_Errors ("all is well", Errors, None);
      Receive_Block (Uplink_Of (16#300#));
      Run_TELIN ("new", Is_New => True);
      Expect_Errors ("nobody took", Errors, (1 => Input_Not_Consumed));
      Expect_Buffer
        ("the newest", Up.Taken ("the newest", Input), Uplink_Of (16#300#));
   end Not_Consumed;

   procedure Cold_Again is
   begin
      --  The board has received messages before, but the start has lost the
      --  last one: no substitute may reach the servos.
      New_Block;
      TELIN.Initialise;
      Run_TELIN ("after a start", Is_New => False);
      Up.Expect_Counts ("nothing sent", Input, 1, 1);
      Expect_Errors ("no block", Errors, (1 => TELIN_No_Block));
      Receive_Block (Uplink_Of (16#200#));
      Run_TELIN ("new", Is_New => True);
      Expect_Buffer
        ("sent when one has come", Up.Taken ("sent", Input),
         Uplink_Of (16#200#));
   end Cold_Again;

   procedure Refused_Is_Missed is
      Other : Block_Data := Plain_Messages.Block_Of (Uplink_Of (16#200#));
   begin
      New_Block;
      Other (1) := URV.Seal_Blocks.Sealed_Mark;
      Receive_Data (Other);
      Run_TELIN ("another format", Is_New => False);
      Expect_Buffer
        ("previous", Up.Taken ("previous", Input),
         As_Old (Uplink_Of (16#100#)));
      Expect_Errors
        ("refused and missed", Errors, (TELIN_No_Block, Block_Refused),
         Detail => URV.Uplink_Input.Reason (Wrong_Format));
   end Refused_Is_Missed;

   procedure Age_Of_This_Frame is
      Keys    : constant URV.Sessions.Key_List :=
        (URV.Sessions.First  => (True, 1, Published_Tags.Count_Key),
         URV.Sessions.Second => (others => <>));
      Peer    : URV.Shared_Seals.Shared_Seal (Ground);
      Frame   : Clock_Tick := 0;
      Data    : Block_Data;
      Words   : Block_Words;
      Is_New  : Boolean;
      Unused  : Outcome;
   begin
      Board_In.Start;
      Input.Reset;
      TELIN.Initialise;
      Sealing_In.Configure (2, Keys, 500);
      Peer.Configure (2, Keys, 1_000);

      --  Both nodes come to a session.
      for Step in 1 .. 12 loop
         Frame := Frame + Ticks_Per_Major_Frame;
         Peer.Set_Time (Frame);
         Peer.Close
           (URV.Codecs.Uplink.Words_Of (Uplink_Of (16#100#)), Data);
         Receive_Data (Data);
         TELIN.Run_Transaction (Frame, Is_New);
         Sealing_In.Close
           (URV.Codecs.Downlink.Words_Of (Downlink_Of (16#300#)), Data);
         Peer.Open (Data, True, Words, Unused);
      end loop;
      Expect ("a session", Is_New, True);

      --  A block that was sealed before the aircraft stood still, for longer
      --  than a block may be old.
      Frame := Frame + Ticks_Per_Major_Frame;
      Peer.Set_Time (Frame);
      Peer.Close (URV.Codecs.Uplink.Words_Of (Uplink_Of (16#200#)), Data);
      Receive_Data (Data);
      Errors.Clear;
      Input.Reset;
      Run_TELIN
        ("a late block", Is_New => False,
         Now => Frame + 30 * Ticks_Per_Major_Frame);
      Expect_Errors
        ("a late block", Errors, (TELIN_No_Block, Block_Refused),
         Detail => URV.Uplink_Input.Reason (Too_Late));
      Sealing_In.Configure (1, (others => (others => <>)), 0);
   end Age_Of_This_Frame;

   procedure New_Output is
   begin
      Prepare_Board_Out;
      Output.Reset;
      Errors.Clear;
      Down.Give (Output, Downlink_Of (16#300#));
      TELOUT.Run_Transaction;
      Down.Expect_Counts ("received", Output, 1, 1);
      Expect_Block ("block", Downlink_Of (16#300#));
      Expect_Errors ("new output", Errors, None);
   end New_Output;

   procedure No_Output_Now is
   begin
      New_Output;
      Prepare_Board_Out;
      TELOUT.Run_Transaction;
      Expect_No_Block ("nothing was put");
      Expect_Errors ("nothing new", Errors, (1 => No_Output));
   end No_Output_Now;

   procedure No_Buffer is
   begin
      New_Output;
      Prepare_Board_Out;
      for Mark in Word range 1 .. 3 loop
         Down.Give (Output, Downlink_Of (16#100# * Mark));
         TELOUT.Run_Transaction;
         Expect_Errors
           ("put" & Mark'Image, Errors,
            (if Mark < 3 then None else (1 => TELOUT_Overwrote_Block)));
      end loop;
      Expect_Block ("the newest", Downlink_Of (16#300#));
   end No_Buffer;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "TIN-1 before the first message nothing is sent",
         Before_The_First'Access);
      Add (Suite, "TIN-1 a new block is sent on", New_Block'Access);
      Add
        (Suite, "TIN-1 without a new block the one before is sent on",
         Block_Again'Access);
      Add
        (Suite, "TIN-1 a message not taken is reported",
         Not_Consumed'Access);
      Add
        (Suite, "INI-8 TIN-1 a start sends nothing on until a message comes",
         Cold_Again'Access);
      Add
        (Suite, "SEC-1 a refused block is reported and missed",
         Refused_Is_Missed'Access);
      Add
        (Suite, "SEC-4 a block's age is that of the frame that opens it",
         Age_Of_This_Frame'Access);
      Add (Suite, "TOU-1 a new message goes to the board", New_Output'Access);
      Add
        (Suite, "TOU-1 nothing is written when nothing new has come",
         No_Output_Now'Access);
      Add
        (Suite, "TOU-1 a block that replaces another is reported",
         No_Buffer'Access);
   end Add_To;

end Telemetry_Task_Tests;
