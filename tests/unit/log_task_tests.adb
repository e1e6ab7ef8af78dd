with Checks;               use Checks;
with Devices.CORE_Memory;  use Devices.CORE_Memory;
with Devices.Shared_CORE_Memory;
with Expectations;         use Expectations;
with Telemetry.Boards;     use Telemetry.Boards;
with URVOS;                use URVOS;
with URVOS.Frames;         use URVOS.Frames;
with URV.Errors;           use URV.Errors;
with URV.Log_Pieces;       use URV.Log_Pieces;
with URV.Log_Receivers;
with URV.Log_Senders;
with URV.LOG_Task;
with URV.Shared_Errors;

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

   --  The board under the task.
   Tally : Statistics;

   procedure Inspect_Link (Now : out Statistics);

   package Errors is new URV.Shared_Errors;
   package CORE is new Devices.Shared_CORE_Memory;

   --  Both ends of the log's way.

   package Log_Sender is new URV.Log_Senders (Inspect_Log => Errors.Inspect);

   package Log_Receiver is new URV.Log_Receivers
     (Write_Row => CORE.Write_Aircraft_Log);

   --  What comes down in a frame: a piece, or nothing new.
   Piece_Sent : Piece   := No_Piece;
   Is_Lost    : Boolean := False;

   procedure Fly_Frame;

   package Under_Test is new URV.LOG_Task
     (Inspect_Link   => Inspect_Link,
      Report_Several => Errors.Report_Several,
      Inspect_Log    => Errors.Inspect,
      Write_Status   => CORE.Write_Status,
      Write_Log      => CORE.Write_Log);

   --  All as after a cold start.
   procedure Begin_Test;

   function Status (Item : Status_Item) return Word;
   function History (Kind : Error_Kind) return Logs.History;

   procedure Fly_Frame is
   begin
      Under_Test.Run_Transaction;
      Log_Sender.Next (Piece_Sent);
      if not Is_Lost then
         Log_Receiver.Take_Piece (Piece_Sent);
      end if;
   end Fly_Frame;

   procedure Inspect_Link (Now : out Statistics) is
   begin
      Now := Tally;
   end Inspect_Link;

   procedure Begin_Test is
   begin
      Tally := (others => 0);
      CORE.Clear;
      Errors.Set_Time (0);
      Errors.Clear;
      Is_Lost := False;
      Under_Test.Initialise;
   end Begin_Test;

   function Status (Item : Status_Item) return Word is
      Snapshot : Memory;
   begin
      CORE.Inspect (Snapshot);
      return Snapshot.Status (Item);
   end Status;

   function History (Kind : Error_Kind) return Logs.History is
      Log : Error_Log;
   begin
      Errors.Inspect (Log);
      return Logs.History_Of (Log, Kind);
   end History;

   procedure Nothing_Happened is
   begin
      Begin_Test;
      Tally := (Sent => 50, Received => 40, others => 0);
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
      Tally :=
        (Bad => 2, Not_Taken => 3, Scrapped => 4, Cleared => 5, Resets => 6,
         others => 100);
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
      Tally.Resets := 7;
      Errors.Set_Time (45);
      Under_Test.Run_Transaction;
      Expect ("one more", History (Link_Reset).Occurrences, 7);
      Expect ("first", History (Link_Reset).First, 25);
      Expect ("last", History (Link_Reset).Last, 45);
      Expect ("how many", History (Link_Reset).Last_Detail, 1);
      Expect ("no other", History (Link_Block_Bad).Last, 25);
   end Only_The_New;

   procedure Board_Off_And_On is
   begin
      Link_Kinds;
      Tally := (Bad => 1, others => 0);
      Under_Test.Run_Transaction;
      Expect ("bad", History (Link_Block_Bad).Occurrences, 3);
      Expect ("resets", History (Link_Reset).Occurrences, 6);
   end Board_Off_And_On;

   procedure Cold_Only is
   begin
      --  What the board has counted before a cold start is not logged.
      Begin_Test;
      Tally := (others => 1_000);
      Under_Test.Initialise;
      Under_Test.Run_Transaction;
      Expect ("bad", History (Link_Block_Bad).Occurrences, 0);
      Tally.Bad := 1_001;
      Under_Test.Run_Transaction;
      Expect ("bad after it", History (Link_Block_Bad).Occurrences, 1);

      --  What it counts before a warm start is.
      Tally.Bad := 1_003;
      Errors.Report (Processor_Restart, 0);
      Under_Test.Initialise;
      Under_Test.Run_Transaction;
      Expect ("bad with a restart", History (Link_Block_Bad).Occurrences, 3);
      Tally.Bad := 1_006;
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

      Errors.Report_Several (ROM_Check_Failed, 65_536, 1);
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
      Tally.Bad := 70_000;
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
      CORE.Write_Downlink ((others => 9));
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

      --  Nothing has happened, nothing is sent.
      Fly_Frame;
      Expect ("no piece", Piece_Sent, 0);

      --  Each kind, another number of times, at other times.
      for Kind in Error_Kind loop
         Errors.Set_Time (Clock_Tick (1 + Error_Kind'Pos (Kind)) * 700_000);
         Errors.Report (Kind, 1);
         Errors.Set_Time
           (Clock_Tick (1 + Error_Kind'Pos (Kind)) * 1_400_000);
         Errors.Report_Several
           (Kind, 66_000 + Error_Kind'Pos (Kind),
            16#ABC0# + Error_Kind'Pos (Kind));
      end loop;

      --  15 pieces a kind, and those of the round that had begun.
      for Frame in 1 .. 16 * (Error_Kind'Pos (Error_Kind'Last) + 2) loop
         Fly_Frame;
      end loop;

      CORE.Inspect (Snapshot);
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
      --  Every fourth downlink is lost until the row has been sent some
      --  times: never is a row taken that has a hole. Then it comes whole.
      Begin_Test;
      Errors.Report (No_Input, 16#1234#);
      for Frame in 1 .. 100 loop
         Is_Lost := Frame mod 4 = 0;
         Fly_Frame;
      end loop;
      CORE.Inspect (Snapshot);
      Expect
        ("a row with a hole", (for all Row of Snapshot.Aircraft_Log =>
                                 Row = No_Errors), True);
      Is_Lost := False;
      for Frame in 1 .. 31 loop
         Fly_Frame;
      end loop;
      CORE.Inspect (Snapshot);
      Expect
        ("the row",
         Snapshot.Aircraft_Log (Error_Kind'Pos (No_Input) + 1) (Last_Detail),
         16#1234#);
   end Pieces_Lost;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "EXT-1 when all is well the log stays empty",
         Nothing_Happened'Access);
      Add
        (Suite, "EXT-1 each error that the board counts has its kind",
         Link_Kinds'Access);
      Add
        (Suite, "EXT-1 only what is new on the link is logged",
         Only_The_New'Access);
      Add
        (Suite, "EXT-1 a board that was off is counted anew",
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
   end Add_To;

end LOG_Task_Tests;
