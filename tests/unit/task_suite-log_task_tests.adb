--  SPDX-License-Identifier: Apache-2.0

with Checks;              use Checks;
with Expectations;        use Expectations;
with Telemetry;           use Telemetry;
with Telemetry.Checksum;
with Telemetry.Headers;   use Telemetry.Headers;
with Telemetry.Receivers; use Telemetry.Receivers;
with Telemetry.Shared_Boards;
with URVOS;               use URVOS;
with URVOS.Frames;        use URVOS.Frames;
with URV.Card_Status;
with URV.CORE_Memory;     use URV.CORE_Memory;
with URV.Errors;          use URV.Errors;
with URV.LAW_Steps;
with URV.Law_Status;
with URV.Laws;
with URV.Log_Pieces;      use URV.Log_Pieces;
with URV.LOG_Steps;
with URV.Log_Receivers;
with URV.Log_Senders;
with URV.LOG_Task;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors;
with URV.Shared_Laws;
with URV.Surfaces;

separate (Task_Suite)
package body LOG_Task_Tests is

   --  The tests, in order.
   procedure Nothing_Happened;
   procedure Link_Kinds;
   procedure Only_The_New;
   procedure Board_Off_And_On;
   procedure Cold_Only;
   procedure Sums;
   procedure Long_Flight;
   procedure Status_Kept;
   procedure Whole_Log;
   procedure Pieces_Lost;
   procedure Row_Lost;
   procedure No_Such_Row;
   procedure Rows_In_Turn;
   procedure Age_Of_Node;
   procedure Failures_Of_Laws;

   --  The task's surroundings. The board is an aircraft's, and keeps the
   --  counts of earlier tests.

   Board : Telemetry.Shared_Boards.Shared_Board
     (Role => Aircraft, Transmit_Length => 4, Receive_Length => 2);

   Errors : URV.Shared_Errors.Shared_Log;
   CORE   : URV.Shared_CORE_Memory.Board;

   --  Both ends of the log's path

   Law_Settings : URV.Shared_Laws.Settings.Store;
   Law_Memory   : URV.Shared_Laws.Memory_Store;

   package Log_Sender is new URV.Log_Senders
     (Errors, Law_Settings, Law_Memory);

   package Log_Receiver is new URV.Log_Receivers (CORE);

   --  The fragment received in a frame, or none.
   Piece_Sent : Piece   := No_Piece;
   Is_Lost    : Boolean := False;

   procedure Fly_Frame;

   package Under_Test is new URV.LOG_Task (Board, CORE, Errors);

   --  Events at the board

   procedure Hear (Value : Byte);
   procedure Speak;
   procedure Hear_Block (Is_Good : Boolean);
   procedure Take_Block;
   procedure Put_Block;

   --  Sends the waiting block and answers it.
   procedure Send_Block (Is_Confirmed : Boolean);

   --  The board loses step and resets itself.
   procedure Lose_Step;

   --  A block of the ground is cut short: it is bad, and the board resets
   --  itself.
   procedure Cut_Block_Short;

   --  Restores the state after a cold start.
   procedure Begin_Test;

   function Status (Item : Status_Item) return Word is
     (CORE.Contents.Status (Item));

   function History (Kind : Error_Kind) return Logs.History is
     (Logs.History_Of (Errors.Contents, Kind));

   procedure Fly_Frame is
   begin
      Under_Test.Run_Transaction;
      Log_Sender.Next (Piece_Sent);
      if not Is_Lost then
         Log_Receiver.Take_Piece (Piece_Sent);
      else
         Log_Receiver.Miss_Piece;
      end if;
   end Fly_Frame;

   procedure Hear (Value : Byte) is
      Unused : Boolean;
   begin
      Board.Accept_Character (0, Value, False, Unused);
   end Hear;

   procedure Speak is
      Send        : Boolean;
      Unused_Data : Byte;
      Unused_Time : Character_Times;
   begin
      loop
         Board.Next_Character (0, Send, Unused_Data, Unused_Time);
         exit when not Send;
      end loop;
   end Speak;

   procedure Hear_Block (Is_Good : Boolean) is
      Sum : constant Byte :=
        Checksum.Of_Message (Data_Header (2), (others => 0), 2);

      Answers     : Boolean;
      Unused_Data : Byte;
      Unused_Time : Character_Times;
   begin
      Hear (Data_Header (2));
      Hear (0);
      Hear (0);
      Hear (if Is_Good then Sum else Sum xor 1);
      Board.Next_Character
        (Telemetry.Guard_Time, Answers, Unused_Data, Unused_Time);
      Expect ("answers", Answers, True);
      Speak;
   end Hear_Block;

   procedure Take_Block is
      Unused_Data        : Block_Data;
      Unused_Fresh, Ever : Boolean;
   begin
      Board.Take (Unused_Data, Unused_Fresh, Ever);
      Expect ("a block has come", Ever, True);
   end Take_Block;

   procedure Put_Block is
      Overwrote : Boolean;
   begin
      Board.Put ((others => 1), Overwrote);
      Expect ("there is a transmit buffer", Overwrote, False);
   end Put_Block;

   procedure Send_Block (Is_Confirmed : Boolean) is
   begin
      Hear (Encode ((Kind => Command_To_Downlink)));
      Speak;
      Hear
        (Encode
           ((Kind           => Headers.Status,
             Good           => Is_Confirmed,
             Wants_Downlink => False)));
      Speak;
   end Send_Block;

   procedure Lose_Step is
      Before      : constant Count := Board.Tally.Resets;
      Send        : Boolean;
      Unused_Data : Byte;
      Unused_Time : Character_Times;
   begin
      Hear (16#FF#);
      Board.Next_Character (100, Send, Unused_Data, Unused_Time);
      Expect ("reset", Board.Tally.Resets, Before + 1);
   end Lose_Step;

   procedure Cut_Block_Short is
      Unused_Send : Boolean;
      Unused_Data : Byte;
      Unused_Time : Character_Times;
   begin
      Hear (Data_Header (2));
      Board.Next_Character (100, Unused_Send, Unused_Data, Unused_Time);
   end Cut_Block_Short;

   procedure Begin_Test is
   begin
      Board.Clear_Transmit_Half;
      Board.Start;
      CORE.Clear;
      Errors.Set_Time (0);
      Errors.Clear;
      Is_Lost := False;
      Log_Sender.Progress.Write ((others => <>));
      Log_Receiver.Incoming.Write ((others => <>));
      Under_Test.Initialise;
   end Begin_Test;

   procedure Nothing_Happened is
      Before : Statistics;
   begin
      Begin_Test;
      Before := Board.Tally;
      for Time in 1 .. 5 loop
         Put_Block;
         Send_Block (Is_Confirmed => True);
         Hear_Block (Is_Good => True);
         Take_Block;
      end loop;
      Expect ("sent", Board.Tally.Sent, Before.Sent + 5);
      Expect ("received", Board.Tally.Received, Before.Received + 5);
      Under_Test.Run_Transaction;
      for Item in Status_Item loop
         Expect (Item'Image, Status (Item), 0);
      end loop;
      for Kind in Error_Kind loop
         Expect (Kind'Image, History (Kind).Occurrences, 0);
      end loop;
   end Nothing_Happened;

   procedure Link_Kinds is
   begin
      Begin_Test;
      Errors.Set_Time (25);
      for Time in 1 .. 2 loop
         Hear_Block (Is_Good => False);
      end loop;
      for Time in 1 .. 3 loop
         Hear_Block (Is_Good => True);
         Hear_Block (Is_Good => True);
         Take_Block;
      end loop;
      for Time in 1 .. 4 loop
         Put_Block;
         Send_Block (Is_Confirmed => False);
         Send_Block (Is_Confirmed => False);
      end loop;
      for Time in 1 .. 5 loop
         Put_Block;
         Put_Block;
         Send_Block (Is_Confirmed => True);
      end loop;
      for Time in 1 .. 6 loop
         Lose_Step;
      end loop;
      Under_Test.Run_Transaction;
      Expect ("bad", History (Link_Block_Bad).Occurrences, 2);
      Expect ("not taken", History (Link_Block_Not_Taken).Occurrences, 3);
      Expect ("scrapped", History (Link_Block_Scrapped).Occurrences, 4);
      Expect ("cleared", History (Link_Block_Cleared).Occurrences, 5);
      Expect ("resets", History (Link_Reset).Occurrences, 6);
      Expect ("when", History (Link_Reset).First, 25);
      Expect ("how many", History (Link_Reset).Last_Detail, 6);
      Expect ("all of them", Status (Error_Total_Low), 20);
   end Link_Kinds;

   procedure Only_The_New is
   begin
      Link_Kinds;
      Errors.Set_Time (35);
      Under_Test.Run_Transaction;
      Expect ("still the same", History (Link_Reset).Last, 25);
      Lose_Step;
      Errors.Set_Time (45);
      Under_Test.Run_Transaction;
      Expect ("one more", History (Link_Reset).Occurrences, 7);
      Expect ("first", History (Link_Reset).First, 25);
      Expect ("last", History (Link_Reset).Last, 45);
      Expect ("how many", History (Link_Reset).Last_Detail, 1);
      Expect ("no other", History (Link_Block_Bad).Last, 25);
   end Only_The_New;

   procedure Board_Off_And_On is
      Seen : URV.LOG_Steps.Progress;
   begin
      --  The task has seen higher counts than the board has now.
      Link_Kinds;
      Seen := Under_Test.Seen.Contents;
      Seen.Seen_Tally.Bad := Board.Tally.Bad + 100;
      Under_Test.Seen.Write (Seen);
      Under_Test.Run_Transaction;
      Expect
        ("bad", History (Link_Block_Bad).Occurrences, 2 + Board.Tally.Bad);
      Expect ("resets", History (Link_Reset).Occurrences, 6);

      --  From there on it counts new events.
      Hear_Block (Is_Good => False);
      Under_Test.Run_Transaction;
      Expect
        ("bad then", History (Link_Block_Bad).Occurrences,
         2 + Board.Tally.Bad);
   end Board_Off_And_On;

   procedure Cold_Only is
   begin
      --  The board's counts before a cold start are not logged.
      Begin_Test;
      for Time in 1 .. 10 loop
         Hear_Block (Is_Good => False);
      end loop;
      Under_Test.Initialise;
      Under_Test.Run_Transaction;
      Expect ("bad", History (Link_Block_Bad).Occurrences, 0);
      Hear_Block (Is_Good => False);
      Under_Test.Run_Transaction;
      Expect ("bad after it", History (Link_Block_Bad).Occurrences, 1);

      --  The board's counts before a warm start are logged.
      for Time in 1 .. 2 loop
         Hear_Block (Is_Good => False);
      end loop;
      Errors.Report (Processor_Restart, 0);
      Under_Test.Initialise;
      Under_Test.Run_Transaction;
      Expect ("bad with a restart", History (Link_Block_Bad).Occurrences, 3);
      for Time in 1 .. 3 loop
         Hear_Block (Is_Good => False);
      end loop;
      Errors.Clear;
      Errors.Report (Warm_Reset, 0);
      Under_Test.Initialise;
      Under_Test.Run_Transaction;
      Expect ("bad with a reset", History (Link_Block_Bad).Occurrences, 3);
   end Cold_Only;

   procedure Sums is
   begin
      Begin_Test;
      Errors.Set_Time (1_239);
      Errors.Report (AD_No_Scan, 4);
      Under_Test.Run_Transaction;
      Expect ("total, high", Status (Error_Total_High), 0);
      Expect ("total, low", Status (Error_Total_Low), 1);
      Expect ("the first kind", Status (Last_Error), 1);
      Expect ("frame, high", Status (Last_Error_Frame_High), 0);
      Expect ("frame, low", Status (Last_Error_Frame_Low), 123);

      Errors.Report_Several (Error_Kind'Last, 65_536, 1);
      Under_Test.Run_Transaction;
      Expect ("total, high", Status (Error_Total_High), 1);
      Expect ("total, low", Status (Error_Total_Low), 1);
      Expect
        ("the last kind", Status (Last_Error),
         Error_Kind'Pos (Error_Kind'Last) + 1);
   end Sums;

   procedure Long_Flight is
   begin
      Begin_Test;
      Errors.Set_Time (10 * (2 ** 32 - 1));
      Errors.Report_Several (No_Input, Count'Last, 0);
      Under_Test.Run_Transaction;
      Expect ("total, high", Status (Error_Total_High), 16#7FFF#);
      Expect ("total, low", Status (Error_Total_Low), 16#FFFF#);
      Expect ("frame, high", Status (Last_Error_Frame_High), 16#FFFF#);
      Expect ("frame, low", Status (Last_Error_Frame_Low), 16#FFFF#);

      Errors.Set_Time (10 * 2 ** 32);
      Errors.Report (No_Input, 0);
      for Time in 1 .. 70_000 loop
         Cut_Block_Short;
      end loop;
      Under_Test.Run_Transaction;
      Expect ("frame, high", Status (Last_Error_Frame_High), 16#FFFF#);
      Expect ("frame, low", Status (Last_Error_Frame_Low), 16#FFFF#);
      Expect
        ("how many, at its last value",
         History (Link_Block_Bad).Last_Detail, 16#FFFF#);
      Errors.Set_Time (Last_Tick);
      Under_Test.Run_Transaction;
   end Long_Flight;

   procedure Status_Kept is
   begin
      Begin_Test;
      CORE.Write_Status
        ((Start_Condition => 3, Cold_Starts => 1, Warm_Resets => 2,
          Processor_Restarts => 4));
      CORE.Write_Status ((ROM_Passes => 6));
      Errors.Report (No_Input, 0);
      Under_Test.Run_Transaction;
      CORE.Write_Uplink ((others => 9));
      CORE.Write_Downlink ((others => 9), (others => 9));
      Expect ("condition", Status (Start_Condition), 3);
      Expect ("cold", Status (Cold_Starts), 1);
      Expect ("warm", Status (Warm_Resets), 2);
      Expect ("processor", Status (Processor_Restarts), 4);
      Expect ("passes", Status (ROM_Passes), 6);
      Expect ("failures", Status (ROM_Failures), 0);
      Expect ("total", Status (Error_Total_Low), 1);
      Expect ("one more", Incremented (Word'(6)), 7);
      Expect ("no more", Incremented (Word'Last), Word'Last);
      CORE.Clear;
      for Item in Status_Item loop
         Expect (Item'Image, Status (Item), 0);
      end loop;
   end Status_Kept;

   procedure Whole_Log is
      Snapshot : Memory;
      Row      : Log_Row;
   begin
      Begin_Test;

      --  Nothing has happened, so nothing is sent.
      Fly_Frame;
      Expect ("no piece", Piece_Sent, 0);

      --  Each kind occurs a different number of times, at different times.
      for Kind in Error_Kind loop
         Errors.Set_Time (Clock_Tick (1 + Error_Kind'Pos (Kind)) * 700_000);
         Errors.Report (Kind, 1);
         Errors.Set_Time
           (Clock_Tick (1 + Error_Kind'Pos (Kind)) * 1_400_000);
         Errors.Report_Several
           (Kind, 66_000 + Error_Kind'Pos (Kind),
            16#ABC0# + Error_Kind'Pos (Kind));
      end loop;

      --  15 fragments for each kind, and those of the round already begun.
      for Frame in 1 .. 16 * (Error_Kind'Pos (Error_Kind'Last) + 2) loop
         Fly_Frame;
      end loop;

      Snapshot := CORE.Contents;
      for Kind in Error_Kind loop
         Row := Snapshot.Log (Error_Kind'Pos (Kind) + 1);
         Expect
           (Kind'Image & " came down as it is",
            Snapshot.Aircraft_Log (Error_Kind'Pos (Kind) + 1) = Row, True);
         Expect
           ("times, high", Row (Occurrences_High), 1);
         Expect
           ("times, low", Row (Occurrences_Low),
            465 + Error_Kind'Pos (Kind));
         Expect
           ("first frame",
            Count (Row (First_Frame_High)) * 65_536
            + Count (Row (First_Frame_Low)),
            70_000 * (1 + Error_Kind'Pos (Kind)));
         Expect
           ("last frame",
            Count (Row (Last_Frame_High)) * 65_536
            + Count (Row (Last_Frame_Low)),
            140_000 * (1 + Error_Kind'Pos (Kind)));
         Expect
           ("detail", Row (Last_Detail), 16#ABC0# + Error_Kind'Pos (Kind));
      end loop;
   end Whole_Log;

   procedure Pieces_Lost is
      Snapshot : Memory;
   begin
      --  Every fourth downlink is lost until the row has been sent several
      --  times. A row with a gap is never taken. Then it arrives complete.
      Begin_Test;
      Errors.Report (No_Input, 16#1234#);
      for Frame in 1 .. 100 loop
         Is_Lost := Frame mod 4 = 0;
         Fly_Frame;
      end loop;
      Snapshot := CORE.Contents;
      Expect
        ("a row with a hole", (for all Row of Snapshot.Aircraft_Log =>
                                 Row = No_Errors), True);
      Is_Lost := False;
      for Frame in 1 .. 31 loop
         Fly_Frame;
      end loop;
      Snapshot := CORE.Contents;
      Expect
        ("the row",
         Snapshot.Aircraft_Log (Error_Kind'Pos (No_Input) + 1) (Last_Detail),
         16#1234#);
   end Pieces_Lost;

   procedure Row_Lost is
      Place : constant array (Boolean) of Word := (16#1111#, 16#2222#);
   begin
      --  Two kinds of errors take turns. After a gap of a whole row the other
      --  row continues at the place that the first one had.
      for Gap in 14 .. 16 loop
         for Begun in 1 .. 14 loop
            Begin_Test;
            Errors.Report (No_Input, Place (False));
            Errors.Report (No_Output, Place (True));
            for Frame in 1 .. 15 + Begun + Gap + 15 loop
               Is_Lost := Frame in 16 + Begun .. 15 + Begun + Gap;
               Fly_Frame;
               for Kind in Error_Kind loop
                  Expect
                    (Kind'Image & " whole after" & Gap'Image & Begun'Image,
                     CORE.Contents.Aircraft_Log (Error_Kind'Pos (Kind) + 1)
                       (Last_Detail) in 0
                     | (if Kind = No_Input then Place (False)
                        elsif Kind = No_Output then Place (True) else 0),
                     True);
               end loop;
            end loop;
         end loop;
      end loop;
      Is_Lost := False;
   end Row_Lost;

   procedure No_Such_Row is
      Item     : URV.Log_Pieces.Receiver;
      Complete : Boolean;
   begin
      for Number of Word_List'
        (0, Word (Log_Row_Number'Last) + 1, 255)
      loop
         Take (Item, 16#101#, Complete);
         Expect_Number ("a row begins", Integer (Item.Got), 1);
         Take (Item, 16#100# + Number, Complete);
         Expect ("row" & Number'Image & " is complete", Complete, False);
         Expect_Number ("it has begun", Integer (Item.Got), 0);
         Take (Item, 16#200#, Complete);
         Expect_Number ("nor goes on", Integer (Item.Got), 0);
      end loop;
   end No_Such_Row;

   procedure Rows_In_Turn is
      Off  : constant URV.Laws.Settings   := Law_Settings.Contents;
      Kept : constant URV.LAW_Steps.Kept  := Law_Memory.Contents;
      Came : array (Log_Row_Number) of Natural;
   begin
      --  With a card aboard each row of an error is followed by that of the
      --  laws or of the cards, in turn. Each comes within four rows.
      Begin_Test;
      Law_Settings.Write ((Off with delta On => True));
      Law_Memory.Write
        ((Kept with delta
            Cards => (Kept.Cards with delta
              Run => (Kept.Cards.Run with delta Chosen => 1))));
      Errors.Report (No_Input, 0);
      Came := (others => 0);
      for Round in 1 .. 6 loop
         CORE.Clear;
         for Frame in 1 .. 4 * 15 loop
            Fly_Frame;
         end loop;
         for Which in Log_Row_Number loop
            if CORE.Contents.Aircraft_Log (Which) /= No_Errors then
               Came (Which) := Came (Which) + 1;
            end if;
         end loop;
      end loop;
      Expect_Number
        ("laws", Came (URV.Law_Status.Row_Number), 6);
      Expect_Number
        ("cards", Came (URV.Card_Status.Row_Number), 6);
      Expect_Number
        ("errors", Came (Error_Kind'Pos (No_Input) + 1), 6);
      Law_Settings.Write (Off);
      Law_Memory.Write (Kept);
   end Rows_In_Turn;

   procedure Age_Of_Node is
      Off : constant URV.Laws.Settings := Law_Settings.Contents;

      --  Expects the ground's age of the node after a row of it has come.
      procedure Expect_Age (Frame : Clock_Tick; Age : Word);

      procedure Expect_Age (Frame : Clock_Tick; Age : Word) is
      begin
         Begin_Test;
         Errors.Set_Time (Frame * Ticks_Per_Major_Frame);
         for Piece in 1 .. 15 loop
            Fly_Frame;
         end loop;
         Expect
           ("age in frame" & Frame'Image,
            URV.Law_Status.From_Row
              (CORE.Contents.Aircraft_Log (URV.Law_Status.Row_Number))
              (URV.Law_Status.Age),
            Age);
      end Expect_Age;

   begin
      Law_Settings.Write ((Off with delta On => True));
      Expect_Age (0, 0);
      Expect_Age (15, 0);
      Expect_Age (16, 1);
      Expect_Age (16 * 65_535 + 15, 65_535);
      Expect_Age (16 * 65_536, 0);
      Expect_Age (Last_Tick / Ticks_Per_Major_Frame,
                  Word (Last_Tick / (16 * Ticks_Per_Major_Frame) mod 65_536));
      Law_Settings.Write (Off);
   end Age_Of_Node;

   procedure Failures_Of_Laws is
      use URV.Law_Status;
      Off  : constant URV.Laws.Settings  := Law_Settings.Contents;
      Kept : constant URV.LAW_Steps.Kept := Law_Memory.Contents;
      Flaw : URV.LAW_Steps.Kept          := Kept;
   begin
      --  The right rudder is in bit 5, the throttle in bit 10. The flight
      --  recorder has the same word.
      Flaw.Watched.Failed (URV.Surfaces.Right_Rudder) := True;
      Flaw.Watched.Engine.Failed := True;
      Begin_Test;
      Law_Settings.Write ((Off with delta On => True));
      Law_Memory.Write (Flaw);
      for Piece in 1 .. 15 loop
         Fly_Frame;
      end loop;
      Expect
        ("the laws' row",
         From_Row (CORE.Contents.Aircraft_Log (Row_Number)) (Failed),
         32 + 1_024);
      Expect ("the recorder", Law_Memory.Recorded.Laws (5), 32 + 1_024);
      Law_Settings.Write (Off);
      Law_Memory.Write (Kept);
   end Failures_Of_Laws;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "EXT-1 when all is well the log stays empty",
         Nothing_Happened'Access);
      Add
        (Suite, "EXT-1 each error that the board counts has its kind",
         Link_Kinds'Access);
      Add
        (Suite, "EXT-1 only new link counts are logged",
         Only_The_New'Access);
      Add
        (Suite, "EXT-1 a board that was off is counted from zero",
         Board_Off_And_On'Access);
      Add
        (Suite, "EXT-1 at a cold start the board's old counts are not logged",
         Cold_Only'Access);
      Add
        (Suite, "EXT-1 INI-6 the log's sums are in CORE's status",
         Sums'Access);
      Add
        (Suite, "EXT-1 sums and frames stay at their last value",
         Long_Flight'Access);
      Add
        (Suite, "INI-6 a status word stays until it is written or cleared",
         Status_Kept'Access);
      Add
        (Suite, "SAF-7 the whole log is in CORE and comes to the ground",
         Whole_Log'Access);
      Add
        (Suite, "SAF-7 a row of the log comes whole or not at all",
         Pieces_Lost'Access);
      Add
        (Suite, "SAF-7 after a gap of a row no two rows are mixed",
         Row_Lost'Access);
      Add
        (Suite, "SAF-7 a row that there is not is not taken",
         No_Such_Row'Access);
      Add
        (Suite, "FTI-2 the rows of the laws and the cards take turns",
         Rows_In_Turn'Access);
      Add
        (Suite, "GND-45 the ground knows the age of the aircraft's node",
         Age_Of_Node'Access);
      Add
        (Suite, "EXT-6 the laws' row names failed surfaces and the throttle",
         Failures_Of_Laws'Access);
   end Add_To;

end LOG_Task_Tests;
