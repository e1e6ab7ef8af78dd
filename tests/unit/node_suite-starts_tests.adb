--  SPDX-License-Identifier: Apache-2.0

with Checks;            use Checks;
with Devices.AD_Board;
with Devices.PWM_Board; use Devices.PWM_Board;
with Expect_Value;
with Expectations;      use Expectations;
with GSC.Virtual_Time;
with MCS.Virtual_Time;
with Host.Memory_Hardware;
with Node_Rig;          use Node_Rig;
with Published_Tags;
with Telemetry;         use Telemetry;
with Telemetry.Checksum;
with Telemetry.Headers;
with Telemetry.Receivers;
with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Self_Tests;  use URVOS.Self_Tests;
with URVOS.Shared_Mailboxes;
with URVOS.Start_Phases;
with URVOS.Starts;
with URVOS.Task_Trees;  use URVOS.Task_Trees;
with URV.AD_Scans;
with URV.Buffers;       use URV.Buffers;
with URV.Card_Status;
with Plain_Messages;
with URV.Codecs;
with URV.CORE_Layout;   use URV.CORE_Layout;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Errors;        use URV.Errors;
with URV.LAW_Steps;
with URV.Log_Pieces;
with URV.Mailboxes;     use URV.Mailboxes;
with URV.Plain_Blocks;
with URV.Recorder_Rows;
with URV.Recorder_Steps;
with URV.Seal_Blocks;
with URV.Sessions;
with URV.Test_Runs;
with URV.Type_Codes;    use URV.Type_Codes;

separate (Node_Suite)
package body Starts_Tests is

   use type Starts.Start_Condition;
   subtype Condition_Name is Starts.Start_Condition;
   --  Only a processor restart does not test the memories.
   subtype Fully_Tested is Condition_Name
     range Starts.Warm_Reset .. Starts.Warm_Reset;
   subtype Warm_Condition is Condition_Name
     range Starts.Warm_Reset .. Starts.Processor_Restart;

   --  The tests, in order.
   procedure Phases;
   procedure Counted;
   procedure Boards_Of_Aircraft;
   procedure Variables_Of_Aircraft;
   procedure Variables_Of_Ground;
   procedure Orders_Of_Both;
   procedure Cards_Of_Aircraft;
   procedure Rows_Of_Aircraft;
   procedure Requests_Of_Aircraft;
   procedure Rows_Under_Way;
   procedure Sessions_Of_Both;
   procedure Transmit_Half;
   procedure Receive_Half;
   procedure Converters;
   procedure Codes_Again;
   procedure Servos_Held;
   procedure Flight_Goes_On;
   procedure Silent_Aircraft;
   procedure Silent_Ground;
   procedure Restarted_In_Flight;
   procedure Broken_Off;
   procedure More_Processors;

   --  Both nodes have flown: commands from 100h, sensors from 500h. Then the
   --  link was cut, so the log has entries.
   procedure Fly_Before;

   function Occurrences (Node : Station; Kind : Error_Kind) return Count is
     (Logs.History_Of (Log_Of (Node), Kind).Occurrences);

   --  Runs phases one and two of a start; the tasks are not loaded.
   procedure Begin_Again (Node : Station; Condition : Condition_Name);

   --  The contents of a variable after such a start.
   generic
      with package Messages is new URVOS.Shared_Mailboxes (<>);
      Variable : in out Messages.Variable;
   procedure Expect_Variable (What : String; Node : Station);

   procedure Fly_Before is
   begin
      Switch_On;
      Console := Numbered (16#100#);
      Sensors := Numbered (16#500#);
      Fly (6);
      Link_Is_Cut := True;
      Fly (2);
      Clock_Tick_Of_Both;
   end Fly_Before;

   procedure Begin_Again (Node : Station; Condition : Condition_Name) is
      Passed : Boolean;
   begin
      case Node is
         when Ground =>
            GSC.Starts.Begin_Again (Condition, Clock_Of (Node), Passed);
         when Aircraft =>
            MCS.Starts.Begin_Again (Condition, Clock_Of (Node), Passed);
      end case;
      Expect ("self-test passed", Passed, True);
   end Begin_Again;

   procedure Expect_Variable (What : String; Node : Station) is
      use type Messages.Message;
      Before, After : Messages.Boxes.Mailbox;
   begin
      for Condition in Condition_Name loop
         declare
            Where : constant String := Condition'Image & ", " & What;
         begin
            Fly_Before;
            Before := Variable.Snapshot;
            Expect
              (Where & " holds something before",
               Messages.Boxes.Contents (Before) /= Messages.Neutral,
               True);
            Expect
              (Where & " has been used before",
               Count (Messages.Boxes.Produced (Before)) > 0, True);

            Begin_Again (Node, Condition);
            After := Variable.Snapshot;
            Expect
              (Where & ", produced", Count (Messages.Boxes.Produced (After)),
               0);
            Expect
              (Where & ", consumed", Count (Messages.Boxes.Consumed (After)),
               0);
            Expect (Where & ", misses", Messages.Boxes.Misses (After), 0);
            Expect
              (Where & ", message",
               Messages.Boxes.Contents (After) =
                 (if Condition = Starts.Cold_Start then Messages.Neutral
                  else Messages.Boxes.Contents (Before)),
               True);
         end;
      end loop;
   end Expect_Variable;

   procedure Phases is

      type Step is
        (Nothing, Time_Set, Tested, Cold_Routine, Reset_Routine,
         Restart_Routine, Recorded, Refused);
      type Step_List is array (1 .. 6) of Step;
      procedure Expect is new Expect_Value (Step);

      Done         : Step_List;
      Length       : Natural;
      Test_Passes  : Boolean;

      procedure Note (What : Step);
      procedure Test
        (Unused_Condition : Condition_Name; Result : out Test_Result);
      procedure Record_Start
        (Condition : Condition_Name; Result : Test_Result);
      procedure Refuse;
      procedure Cold_Start;
      procedure Warm_Reset;
      procedure Processor_Restart;
      procedure Set_Time (Unused_Now : Clock_Tick);

      procedure Note (What : Step) is
      begin
         Length := Length + 1;
         Done (Length) := What;
      end Note;

      procedure Test
        (Unused_Condition : Condition_Name; Result : out Test_Result) is
      begin
         Note (Tested);
         Result := (if Test_Passes then All_Passed else Failure (ROM));
      end Test;

      procedure Record_Start
        (Condition : Condition_Name; Result : Test_Result)
      is
         pragma Unreferenced (Condition);
      begin
         Note (Recorded);
         Expect ("result", Result.Passed, Test_Passes);
      end Record_Start;

      procedure Refuse is
      begin
         Note (Refused);
      end Refuse;

      procedure Cold_Start is
      begin
         Note (Cold_Routine);
      end Cold_Start;

      procedure Warm_Reset is
      begin
         Note (Reset_Routine);
      end Warm_Reset;

      procedure Processor_Restart is
      begin
         Note (Restart_Routine);
      end Processor_Restart;

      procedure Set_Time (Unused_Now : Clock_Tick) is
      begin
         Note (Time_Set);
      end Set_Time;

      package Recorded_Phases is new URVOS.Start_Phases
        (Test, Record_Start, Refuse, Cold_Start, Warm_Reset,
         Processor_Restart, Set_Time);

      Passed   : Boolean;
      Expected : Step_List;
   begin
      for Condition in Condition_Name loop
         for Passes in Boolean loop
            Length := 0;
            Done := (others => Nothing);
            Test_Passes := Passes;
            Recorded_Phases.Run (Condition, 7, Passed);
            Expect ("passed", Passed, Passes);

            Expected :=
              (if Passes
               then
                 (Time_Set, Tested,
                  (case Condition is
                      when Starts.Cold_Start        => Cold_Routine,
                      when Starts.Warm_Reset        => Reset_Routine,
                      when Starts.Processor_Restart => Restart_Routine),
                  Recorded, Nothing, Nothing)
               else (Time_Set, Tested, Recorded, Refused, Nothing, Nothing));
            for Place in Done'Range loop
               Expect
                 (Condition'Image & ", test passes " & Passes'Image & ", step"
                  & Place'Image,
                  Done (Place), Expected (Place));
            end loop;
         end loop;
      end loop;
   end Phases;

   procedure Counted is

      --  Starts of each condition after the first cold start.
      Made : constant array (1 .. 6) of Warm_Condition :=
        (Starts.Warm_Reset, Starts.Processor_Restart,
         Starts.Processor_Restart, Starts.Warm_Reset,
         Starts.Processor_Restart, Starts.Processor_Restart);
      Status : Status_Words;
      Resets, Restarts : Word;
   begin
      for Node in Station loop
         Switch_On;
         Fly (3);
         Resets := 0;
         Restarts := 0;
         for Condition of Made loop
            if Condition = Starts.Warm_Reset then
               Resets := Resets + 1;
            else
               Restarts := Restarts + 1;
            end if;
            Start_Again (Node, Condition);
            Fly (1);
            Status := CORE_Of (Node).Status;
            Expect
              (Node'Image & ", condition", Status (Start_Condition),
               (if Condition = Starts.Warm_Reset then 2 else 3));
            Expect (Node'Image & ", cold", Status (Cold_Starts), 1);
            Expect (Node'Image & ", resets", Status (Warm_Resets), Resets);
            Expect
              (Node'Image & ", restarts", Status (Processor_Restarts),
               Restarts);
            Expect (Node'Image & ", self-test", Status (Self_Test_Result), 0);
            Expect
              (Node'Image & ", resets in the log",
               Occurrences (Node, Warm_Reset), Count (Resets));
            Expect
              (Node'Image & ", restarts in the log",
               Occurrences (Node, Processor_Restart), Count (Restarts));
            for Kind in Error_Kind range Warm_Reset .. Processor_Restart loop
               Expect
                 (Node'Image & ", detail",
                  Logs.History_Of (Log_Of (Node), Kind).Last_Detail, 0);
            end loop;
         end loop;

         --  Power fails and returns.
         Start_Again (Node, Starts.Cold_Start);
         Status := CORE_Of (Node).Status;
         Expect (Node'Image & ", condition", Status (Start_Condition), 1);
         Expect (Node'Image & ", cold again", Status (Cold_Starts), 1);
         Expect (Node'Image & ", resets again", Status (Warm_Resets), 0);
         Expect
           (Node'Image & ", restarts again", Status (Processor_Restarts), 0);
         Expect
           (Node'Image & ", log again", Logs.Total (Log_Of (Node)), 0);
      end loop;
   end Counted;

   procedure Boards_Of_Aircraft is
      Held_Servos : Data_Area;
      CORE        : Memory;
      Before      : Count;
   begin
      for Condition in Condition_Name loop
         Fly_Before;
         MCS.Status.Write (ROM_Differs);
         Held_Servos := Servos;
         CORE := CORE_Of_MCS;
         Before := Logs.Total (Log_Of (Aircraft));
         Expect ("servo 1 before", Held_Servos (1), 16#100#);
         Expect ("sensor 1 before", CORE.Downlink (Right_Flap_1), 16#500#);
         Expect ("errors before", Before > 0, True);
         Begin_Again (Aircraft, Condition);

         for Number in Channel_Number loop
            Expect
              (Condition'Image & ", servo" & Number'Image, Servos (Number),
               (if Condition = Starts.Cold_Start then Safe_Words (Number)
                else Held_Servos (Number)));
         end loop;

         if Condition = Starts.Cold_Start then
            CORE := Cleared;
            Before := 0;
         else
            CORE.Uplink (Error_Status) :=
              CORE.Uplink (Error_Status) or Stale_Data;
            CORE.Downlink (Error_Status) :=
              CORE.Downlink (Error_Status) or Stale_Data;
         end if;
         for Item in Uplink_Item loop
            Expect
              (Condition'Image & ", CORE uplink " & Item'Image,
               CORE_Of_MCS.Uplink (Item), CORE.Uplink (Item));
            Expect
              (Condition'Image & ", CORE uplink code " & Item'Image,
               CORE_Of_MCS.Uplink_Codes (Item), CORE.Uplink_Codes (Item));
         end loop;
         for Item in Downlink_Item loop
            Expect
              (Condition'Image & ", CORE downlink " & Item'Image,
               CORE_Of_MCS.Downlink (Item), CORE.Downlink (Item));
            Expect
              (Condition'Image & ", CORE downlink code " & Item'Image,
               CORE_Of_MCS.Downlink_Codes (Item),
               CORE.Downlink_Codes (Item));
         end loop;
         Expect
           (Condition'Image & ", CORE errors",
            CORE_Of_MCS.Status (Error_Total_Low),
            CORE.Status (Error_Total_Low));

         --  A warm start adds itself to the log.
         Expect
           (Condition'Image & ", log", Logs.Total (Log_Of (Aircraft)),
            (if Condition = Starts.Cold_Start then 0 else Before + 1));
         Expect
           (Condition'Image & ", status bits", MCS.Status.Contents,
            No_Error);
      end loop;
   end Boards_Of_Aircraft;

   procedure Variables_Of_Aircraft is
      procedure ADINT is new Expect_Variable
        (For_Sensor_Words, MCS.ADINT_Variable);
      procedure AD is new Expect_Variable
        (For_Sensor_Images, MCS.AD_Variable);
      procedure TELIN is new Expect_Variable
        (For_Uplink, MCS.TELIN_Variable);
      procedure Uplink is new Expect_Variable
        (For_Uplink, MCS.Uplink_Variable);
      procedure Downlink is new Expect_Variable
        (For_Framed_Downlink, MCS.Downlink_Variable);
      procedure TELOUT is new Expect_Variable
        (For_Downlink, MCS.TELOUT_Variable);
      procedure Commands is new Expect_Variable
        (For_Uplink, MCS.Commands_Variable);
      procedure Measured is new Expect_Variable
        (For_Downlink, MCS.Sensors_Variable);
      procedure PWM is new Expect_Variable
        (For_Uplink, MCS.PWM_Variable);
   begin
      ADINT ("ADINT_variable", Aircraft);
      AD ("AD_variable", Aircraft);
      TELIN ("TELIN_variable", Aircraft);
      Uplink ("uplink_variable", Aircraft);
      Downlink ("downlink_variable", Aircraft);
      TELOUT ("TELOUT_variable", Aircraft);
      Commands ("commands_variable", Aircraft);
      Measured ("sensors_variable", Aircraft);
      PWM ("PWM_variable", Aircraft);
   end Variables_Of_Aircraft;

   procedure Variables_Of_Ground is
      procedure ADINT is new Expect_Variable
        (For_Stick_Words, GSC.ADINT_Variable);
      procedure AD is new Expect_Variable
        (For_Stick_Images, GSC.AD_Variable);
      procedure TELIN is new Expect_Variable
        (For_Downlink, GSC.TELIN_Variable);
      procedure Uplink is new Expect_Variable
        (For_Uplink, GSC.Uplink_Variable);
      procedure Downlink is new Expect_Variable
        (For_Framed_Downlink, GSC.Downlink_Variable);
      procedure TELOUT is new Expect_Variable
        (For_Uplink, GSC.TELOUT_Variable);
   begin
      ADINT ("ADINT_variable", Ground);
      AD ("AD_variable", Ground);
      TELIN ("TELIN_variable", Ground);
      Uplink ("uplink_variable", Ground);
      Downlink ("downlink_variable", Ground);
      TELOUT ("TELOUT_variable", Ground);
   end Variables_Of_Ground;

   procedure Orders_Of_Both is

      --  A message that no task has taken before a start is not taken after
      --  it.
      generic
         with package Messages is new URVOS.Shared_Mailboxes (<>);
         Variable : in out Messages.Variable;
         Order    : Messages.Message;
      procedure Expect_Order (What : String; Node : Station);

      procedure Expect_Order (What : String; Node : Station) is
         use type Messages.Message;
         Unused : Boolean;
         After  : Messages.Boxes.Mailbox;
      begin
         for Condition in Condition_Name loop
            Fly_Before;
            Variable.Send (Order, Unused);
            Begin_Again (Node, Condition);
            After := Variable.Snapshot;
            Expect
              (Condition'Image & ", " & What & " is fresh",
               Messages.Boxes.Is_Fresh (After), False);
            Expect
              (Condition'Image & ", " & What,
               Messages.Boxes.Contents (After) =
                 (if Condition = Starts.Cold_Start then Messages.Neutral
                  else Order),
               True);
         end loop;
      end Expect_Order;

      Up   : constant Uplink_Buffer   := (others => 7);
      Down : constant Downlink_Buffer := (others => 7);

      procedure Configuration is new Expect_Order
        (For_Uplink, MCS.Configuration_Variable, Up);
      procedure Request is new Expect_Order
        (For_Uplink, MCS.Recorder_Requests, Up);
      procedure Order is new Expect_Order
        (For_Uplink, GSC.Console_Orders, Up);
      procedure Row is new Expect_Order
        (For_Downlink, GSC.Recorder_Blocks, Down);
   begin
      Configuration ("configuration", Aircraft);
      Request ("request for rows", Aircraft);
      Order ("order", Ground);
      Row ("block of the recorder", Ground);
   end Orders_Of_Both;

   procedure Cards_Of_Aircraft is
      Kept : URV.LAW_Steps.Kept;
   begin
      --  The next downlink and the next row do not have the card that a start
      --  has ended.
      for Condition in Condition_Name loop
         Fly_Before;
         Kept := MCS.Law_Memory.Contents;
         Kept.Cards.Run.Chosen := 3;
         Kept.Cards.Run.Running := 3;
         Kept.Cards.Run.Last_Run := 3;
         Kept.Cards.Run.Frame := 5;
         MCS.Law_Memory.Write (Kept);
         MCS.Law_Record.Write
           ((Laws  => (others => 7),
             Cards => URV.Card_Status.State_Word (Kept.Cards.Run)));
         MCS.Card_Shown.Write
           (URV.Card_Status.Card_Word (Kept.Cards.Run));
         Begin_Again (Aircraft, Condition);
         Expect
           (Condition'Image & ", shown", MCS.Card_Shown.Contents,
            (if Condition = Starts.Cold_Start then 0
             else URV.Test_Runs.Verdict'Pos (URV.Test_Runs.Restarted)));
         Expect
           (Condition'Image & ", recorded", MCS.Law_Record.Contents.Cards,
            (if Condition = Starts.Cold_Start then 0
             else 3 + 256 * 3 + 4_096
                  * URV.Test_Runs.Verdict'Pos (URV.Test_Runs.Restarted)));
         Expect
           (Condition'Image & ", laws", MCS.Law_Record.Contents.Laws (1), 0);
      end loop;
      Switch_On;
   end Cards_Of_Aircraft;

   procedure Rows_Of_Aircraft is

      function Newest return URV.Recorder_Rows.Row;

      function Newest return URV.Recorder_Rows.Row is
         use type URV.Recorder_Rows.Row_Number;
      begin
         return MCS.Recorder.Row_At (MCS.Recorder.Contents.Next - 1);
      end Newest;

      Latest : Clock_Tick;
   begin
      Switch_On;
      Fly (3);
      Expect ("starts", Newest.Words.Starts, 0);
      for Reset in 1 .. 2 loop
         Start_Again (Aircraft, Starts.Warm_Reset);
         Fly (2);
         Expect ("resets", Newest.Words.Starts, Word (Reset));
      end loop;
      for Restart in 1 .. 3 loop
         Start_Again (Aircraft, Starts.Processor_Restart);
         Fly (2);
         Expect ("restarts, too", Newest.Words.Starts, 2 + Word (Restart));
      end loop;

      --  A row has the tick and the number of errors of its own frame, those
      --  included that LOG has found in it.
      for At_Tick in 1 .. 12 loop
         for Tick in 1 .. At_Tick loop
            Clock_Tick_Of_Both;
         end loop;
         Link_Is_Cut := not Link_Is_Cut;
         for Frame in 1 .. 4 loop
            Latest := Newest.Words.Time;
            Fly (1);
            Expect
              ("tick", Newest.Words.Time = Latest + Ticks_Per_Major_Frame,
               True);
            Expect
              ("errors", Newest.Words.Errors,
               CORE_Of_MCS.Status (Error_Total_Low));
         end loop;
      end loop;
      Expect
        ("LOG has found some", Occurrences (Aircraft, Link_Block_Bad)
         + Occurrences (Aircraft, Link_Reset) > 0, True);
   end Rows_Of_Aircraft;

   procedure Requests_Of_Aircraft is
      Unused  : Downlink_Buffer;
      Is_Sent : Boolean;
   begin
      --  A request that came before a start is not answered after it.
      for Condition in Condition_Name loop
         Fly_Before;
         MCS.Recorder_Sender.Progress.Write
           ((Now => URV.Recorder_Steps.Report, others => <>));
         Begin_Again (Aircraft, Condition);
         MCS.Recorder_Sender.Next (Neutral_Downlink, Unused, Is_Sent);
         Expect (Condition'Image & ", answered", Is_Sent, False);
      end loop;
      Switch_On;
   end Requests_Of_Aircraft;

   procedure Rows_Under_Way is
      Item : URV.Log_Pieces.Piece;
   begin
      --  A cold start of the aircraft ends the row that it sends, a warm one
      --  does not. Each start of the ground ends the row that it receives.
      for Condition in Condition_Name loop
         Fly_Before;
         MCS.Log_Sender.Progress.Write
           ((Is_Laws => True, Row => (others => 7), Sent => 5, others => <>));
         Begin_Again (Aircraft, Condition);
         MCS.Log_Sender.Next (Item);
         Expect
           (Condition'Image & ", the next fragment",
            (if Condition = Starts.Cold_Start then Item / 256 <= 1
             else Item / 256 = 6),
            True);
         Fly_Before;
         GSC.Log_Receiver.Incoming.Write ((Got => 5, others => <>));
         Begin_Again (Ground, Condition);
         Expect_Number
           (Condition'Image & ", received",
            Integer (GSC.Log_Receiver.Incoming.Contents.Got), 0);
      end loop;
      Switch_On;
   end Rows_Under_Way;

   procedure Sessions_Of_Both is
      Keys : constant URV.Sessions.Key_List :=
        (URV.Sessions.First  => (True, 1, Published_Tags.Count_Key),
         URV.Sessions.Second => (others => <>));

      --  A block that the node seals now.
      function Mark_Of (Node : Station) return Byte;

      function Mark_Of (Node : Station) return Byte is
         Words : constant URV.Plain_Blocks.Block_Words := (others => 0);
         Block : Block_Data;
      begin
         case Node is
            when Ground   => GSC.Sealing.Close (Words, Block);
            when Aircraft => MCS.Sealing.Close (Words, Block);
         end case;
         return URV.Seal_Blocks.Mark_Of (Block);
      end Mark_Of;

   begin
      --  A cold start ends the session of a sealed link, no warm one does.
      GSC.Sealing.Configure (2, Keys, 1_000);
      MCS.Sealing.Configure (2, Keys, 500_000);
      for Node in Station loop
         for Condition in Condition_Name loop
            Switch_On;
            Fly (15);
            Expect
              ("a session", Mark_Of (Node) = URV.Seal_Blocks.Sealed_Mark,
               True);
            Begin_Again (Node, Condition);
            Expect
              (Node'Image & ", " & Condition'Image,
               Mark_Of (Node) =
                 (if Condition = Starts.Cold_Start
                  then URV.Seal_Blocks.Hello_Mark
                  else URV.Seal_Blocks.Sealed_Mark),
               True);
         end loop;
      end loop;
      GSC.Sealing.Configure (1, (others => (others => <>)), 0);
      MCS.Sealing.Configure (1, (others => (others => <>)), 0);
      Switch_On;
   end Sessions_Of_Both;

   procedure Transmit_Half is
      Overwrote : Boolean;
   begin
      for Condition in Condition_Name loop

         --  The aircraft gets no permission: both buffers are full.
         Fly_Before;
         MCS.Telemetry_Board.Put
           (Plain_Messages.Block_Of (Neutral_Downlink), Overwrote);
         Expect ("full before", Overwrote, True);
         Begin_Again (Aircraft, Condition);
         for Buffer in 1 .. 2 loop
            MCS.Telemetry_Board.Put
              (Plain_Messages.Block_Of (Neutral_Downlink), Overwrote);
            Expect
              (Condition'Image & ", full buffer" & Buffer'Image, Overwrote,
               False);
         end loop;

         --  The same on the ground.
         for Buffer in 1 .. 3 loop
            GSC.Telemetry_Board.Put
              (Plain_Messages.Block_Of (Neutral_Uplink), Overwrote);
         end loop;
         Expect ("the ground's full before", Overwrote, True);
         Begin_Again (Ground, Condition);
         for Buffer in 1 .. 2 loop
            GSC.Telemetry_Board.Put
              (Plain_Messages.Block_Of (Neutral_Uplink), Overwrote);
            Expect
              (Condition'Image & ", the ground's full buffer" & Buffer'Image,
               Overwrote, False);
         end loop;
      end loop;
   end Transmit_Half;

   --  A whole message arrives at a node's telemetry board.
   procedure Receive_Message (Node : Station; Data : Block_Data);

   procedure Receive_Message (Node : Station; Data : Block_Data) is
      Length : constant Telemetry.Headers.Block_Length :=
        (if Node = Ground then URV.Codecs.Downlink.Block_Length
         else URV.Codecs.Uplink.Block_Length);

      Unused      : Boolean;
      Answers     : Boolean;
      Status      : Byte;
      Unused_Time : Telemetry.Character_Times;

      procedure Hear (Value : Byte);

      procedure Hear (Value : Byte) is
      begin
         if Node = Ground then
            GSC.Telemetry_Board.Accept_Character (1, Value, False, Unused);
         else
            MCS.Telemetry_Board.Accept_Character (1, Value, False, Unused);
         end if;
      end Hear;

   begin
      Hear (Telemetry.Receivers.Data_Header (Length));
      for I in 1 .. Length loop
         Hear (Data (I));
      end loop;
      Hear
        (Telemetry.Checksum.Of_Message
           (Telemetry.Receivers.Data_Header (Length), Data, Length));

      --  After the guard time the message is taken and answered.
      if Node = Ground then
         GSC.Telemetry_Board.Next_Character
           (Telemetry.Guard_Time, Answers, Status, Unused_Time);
      else
         MCS.Telemetry_Board.Next_Character
           (Telemetry.Guard_Time, Answers, Status, Unused_Time);
      end if;
      Expect ("answers", Answers, True);
   end Receive_Message;

   procedure Receive_Half is
      On    : constant Uplink_Buffer :=
        (Error_Status => No_Error, others => 16#FFF#);
      Data  : Block_Data;
      Fresh : Boolean;
      Ever  : Boolean;
   begin
      for Condition in Condition_Name loop
         Fly_Before;
         MCS.Telemetry_Board.Start;
         Receive_Message (Aircraft, Plain_Messages.Block_Of (On));
         MCS.Telemetry_Board.Take (Data, Fresh, Ever);
         Expect ("a message comes in", Fresh and Ever, True);

         MCS.Telemetry_Board.Start;
         Receive_Message (Aircraft, Plain_Messages.Block_Of (On));
         Begin_Again (Aircraft, Condition);
         MCS.Telemetry_Board.Take (Data, Fresh, Ever);
         Expect
           (Condition'Image & ", what came before the start", Fresh, False);
      end loop;
   end Receive_Half;

   procedure Converters is
      Wanted, Interrupt : Boolean;
      Channel           : Devices.AD_Board.Channel_Number;
      Unused_Reached    : URV.AD_Scans.Channel_Count;
   begin
      for Condition in Condition_Name loop
         Fly_Before;
         MCS.AD_Board.Begin_Scan (Unused_Reached);
         Begin_Again (Aircraft, Condition);
         MCS.AD_Board.Take_Start (Wanted, Channel);
         Expect (Condition'Image & ", a conversion is left", Wanted, False);
         MCS.AD_Board.Begin_Scan (Unused_Reached);
         MCS.AD_Board.Take_Start (Wanted, Channel);
         MCS.AD_Board.Finish (0, Interrupt);
         Expect (Condition'Image & ", interrupt", Interrupt, True);

         --  The AD task's initialisation begins a scan.
         for Node in Station loop
            Start_Again (Node, Condition);
            if Node = Ground then
               GSC.AD_Board.Take_Start (Wanted, Channel);
            else
               MCS.AD_Board.Take_Start (Wanted, Channel);
            end if;
            Expect (Condition'Image & ", " & Node'Image, Wanted, True);
            Expect_Number
              (Condition'Image & ", " & Node'Image & ", channel",
               Integer (Channel), 0);
         end loop;
      end loop;
   end Converters;

   procedure Codes_Again is
      CORE : Memory;
   begin
      for Condition in Condition_Name loop
         Switch_On;
         Fly (3);
         MCS.CORE_Memory.Write_Codes
           ((others => 16#102#), (others => 16#202#), (others => 0));
         GSC.CORE_Memory.Write_Codes
           ((others => 16#102#), (others => 16#202#), (others => 0));
         Fly (3);
         Expect
           ("written once only", CORE_Of_MCS.Uplink_Codes (Roll), 16#102#);
         for Node in Station loop
            Start_Again (Node, Condition);
         end loop;
         Fly (2);
         for Node in Station loop
            CORE := CORE_Of (Node);
            for Item in Uplink_Item loop
               Expect
                 (Condition'Image & ", " & Node'Image & ", " & Item'Image,
                  CORE.Uplink_Codes (Item), Code_Of (Item));
            end loop;
            for Item in Downlink_Item loop
               Expect
                 (Condition'Image & ", " & Node'Image & ", " & Item'Image,
                  CORE.Downlink_Codes (Item), Code_Of (Item));
            end loop;
            for Item in Status_Item loop
               Expect
                 (Condition'Image & ", " & Node'Image & ", " & Item'Image,
                  CORE.Status_Codes (Item), Type_Code (Item));
            end loop;
         end loop;
      end loop;
   end Codes_Again;

   procedure Servos_Held is
      Held : Data_Area;
   begin
      for Condition in Warm_Condition loop
         Fly_Before;
         Held := Servos;
         Console := Numbered (16#300#);
         for Node in Station loop
            Start_Again (Node, Condition);
         end loop;

         --  The ground sends nothing: the aircraft's tasks run, and none has a
         --  command for the servos.
         for Tick in 1 .. 100 loop
            Clock_Tick_Of_Both;
            for Number in Channel_Number loop
               Expect
                 (Condition'Image & ", tick" & Tick'Image & ", servo"
                  & Number'Image,
                  Servos (Number), Held (Number));
            end loop;
         end loop;
         Link_Is_Cut := False;
         Fly (5);
         Expect (Condition'Image & ", new command", Servos (1), 16#300#);
      end loop;
   end Servos_Held;

   procedure Flight_Goes_On is
      GSC_Before : constant Count := GSC.Virtual_Time.Overruns;
      MCS_Before : constant Count := MCS.Virtual_Time.Overruns;

      Frames_To_Recover : constant := 5;

      --  With contracts executed, the start is at every third tick.
      Step : constant Positive := (if Contracts_Are_Executed then 3 else 1);
   begin
      --  At each tick of two frames, either node.
      for Node in Station loop
         for Condition in Warm_Condition loop
            Switch_On;
            Fly (6);
            for At_Tick in 1 .. 20 when At_Tick mod Step = 0 loop
               for Tick in 1 .. At_Tick loop
                  Clock_Tick_Of_Both;
               end loop;
               Start_Again (Node, Condition);
               Console := Numbered (Word (At_Tick) * 16);
               Sensors := Numbered (Word (At_Tick) * 16 + 16#800#);
               Fly (Frames_To_Recover);
               Expect_Commands
                 (Node'Image & " " & Condition'Image & At_Tick'Image,
                  Word (At_Tick) * 16, No_Error);
               Expect_Sensors
                 (Node'Image & " " & Condition'Image & At_Tick'Image,
                  Word (At_Tick) * 16 + 16#800#, No_Error);
               Expect
                 (Node'Image & " " & Condition'Image & At_Tick'Image
                  & ", servo 1",
                  Servos (1), Word (At_Tick) * 16);
            end loop;
         end loop;
      end loop;
      Expect ("overruns of GSC", GSC.Virtual_Time.Overruns, GSC_Before);
      Expect ("overruns of MCS", MCS.Virtual_Time.Overruns, MCS_Before);
   end Flight_Goes_On;

   procedure Silent_Aircraft is
      Held     : Data_Area;
      CORE     : Memory;
      Status   : Status_Words;
      Overfull : Count;

      --  The word of the result, for each fault.
      In_ROM : constant Word := 16#1000#;
      In_RAM : constant Word := 16#2000# + 16#123#;
   begin
      for Fault in Boolean loop
         for Condition in Fully_Tested loop
            Switch_On;
            Console := Numbered (16#100#);
            Sensors := Numbered (16#500#);
            Fly (6);

            --  Both transmit buffers are full of data that is old by now.
            Link_Is_Cut := True;
            Fly (4);
            Overfull := Occurrences (Aircraft, TELOUT_Overwrote_Block);
            Link_Is_Cut := False;
            Held := Servos;
            CORE := CORE_Of_MCS;
            if Fault then
               Host.Memory_Hardware.Spoil_ROM (2, 16#8000#, 1);
            else
               Host.Memory_Hardware.Stick_RAM (2, 16#1234#, 16#0400#);
            end if;
            Start_Again (Aircraft, Condition);
            Console := Numbered (16#200#);
            Sensors := Numbered (16#600#);
            Fly (10);

            --  It reports the reason and does nothing else.
            Status := CORE_Of_MCS.Status;
            Expect
              (Condition'Image & ", result in CORE",
               Status (Self_Test_Result), (if Fault then In_ROM else In_RAM));
            Expect
              (Condition'Image & ", start in CORE", Status (Start_Condition),
               2);
            Expect
              (Condition'Image & ", in the log",
               Occurrences (Aircraft, URV.Errors.Self_Test_Failed), 1);
            Expect
              (Condition'Image & ", result in the log",
               Logs.History_Of
                 (Log_Of (Aircraft), URV.Errors.Self_Test_Failed).Last_Detail,
               (if Fault then In_ROM else In_RAM));
            for Number in Channel_Number loop
               Expect
                 (Condition'Image & ", servo" & Number'Image,
                  Servos (Number), Held (Number));
            end loop;
            Expect
              (Condition'Image & ", CORE", CORE_Of_MCS.Uplink = CORE.Uplink
               and then CORE_Of_MCS.Downlink = CORE.Downlink, True);

            Expect
              (Condition'Image & ", blocks overwritten",
               Occurrences (Aircraft, TELOUT_Overwrote_Block), Overfull);

            --  The ground shows it.
            Expect
              (Condition'Image & ", error word on the ground",
               CORE_Of_GSC.Downlink (Error_Status),
               URV.Buffers.Self_Test_Failed + Stale_Data);
         end loop;
      end loop;
   end Silent_Aircraft;

   procedure Silent_Ground is
      Held   : Data_Area;
      Status : Status_Words;
   begin
      for Condition in Fully_Tested loop
         Switch_On;
         Console := Numbered (16#100#);
         Fly (6);
         Held := Servos;
         Host.Memory_Hardware.Spoil_ROM (1, 0, 16#80#);
         Start_Again (Ground, Condition);
         Console := Numbered (16#200#);
         Fly (10);
         Status := CORE_Of_GSC.Status;
         Expect
           (Condition'Image & ", result in CORE", Status (Self_Test_Result),
            16#1000#);
         Expect
           (Condition'Image & ", in the log",
            Occurrences (Ground, URV.Errors.Self_Test_Failed), 1);
         for Number in Channel_Number loop
            Expect
              (Condition'Image & ", servo" & Number'Image,
               Servos (Number), Held (Number));
         end loop;

         --  After the repair it starts.
         Host.Memory_Hardware.Repair (1);
         Start_Again (Ground, Condition);
         Fly (5);
         Expect
           (Condition'Image & ", passed again",
            CORE_Of_GSC.Status (Self_Test_Result), 0);
         Expect_Commands (Condition'Image & ", again", 16#200#, No_Error);
      end loop;
   end Silent_Ground;

   procedure Restarted_In_Flight is
      Held : Data_Area;
   begin
      for Fault in Boolean loop
         Switch_On;
         Console := Numbered (16#100#);
         Fly (6);
         Held := Servos;
         if Fault then
            Host.Memory_Hardware.Spoil_ROM (2, 16#8000#, 1);
         else
            Host.Memory_Hardware.Stick_RAM (2, 16#1234#, 16#0400#);
         end if;
         Start_Again (Aircraft, Starts.Processor_Restart);
         Expect ("it moves nothing", Servos = Held, True);
         Console := Numbered (16#200#);
         Fly (10);
         Expect
           ("result in CORE", CORE_Of_MCS.Status (Self_Test_Result), 0);
         Expect_Commands ("it flies on", 16#200#, No_Error);
         Host.Memory_Hardware.Repair (2);
      end loop;
   end Restarted_In_Flight;

   procedure Broken_Off is
      Raised : Boolean;
   begin
      Switch_On;
      Console := Numbered (16#100#);
      Sensors := Numbered (16#500#);
      Fly (6);

      --  The start interrupts the self-test task in its turn.
      for Node in Station loop
         Host.Memory_Hardware.Fail_Next_Read (if Node = Ground then 1 else 2);
         Raised := False;
         for Tick in 1 .. 10 loop
            begin
               Clock_Tick_Of_Both;
            exception
               when Host.Memory_Hardware.Bus_Error =>
                  Raised := True;
                  Start_Again (Node, Starts.Processor_Restart);
            end;
         end loop;
         Expect (Node'Image & ", exception", Raised, True);
         Console := Numbered (16#200#);
         Sensors := Numbered (16#600#);
         Fly (5);
         Expect_Commands (Node'Image & ", again", 16#200#, No_Error);
         Expect_Sensors (Node'Image & ", again", 16#600#, No_Error);
         Expect
           (Node'Image & ", restarts",
            CORE_Of (Node).Status (Processor_Restarts), 1);
      end loop;
   end Broken_Off;

   procedure More_Processors is
      Before : constant Count := MCS.Virtual_Time.Overruns;

      Frames : constant := 40;
      type Servo_Record is array (1 .. Frames) of Data_Area;
      type CORE_Record is array (1 .. Frames) of Memory;

      Servos_Of : array (Processor_Number) of Servo_Record;
      COREs_Of  : array (Processor_Number) of CORE_Record;
   begin
      for Processors in Processor_Number loop
         Switch_On (Processors);
         for Frame in 1 .. Frames loop
            Console := Numbered (Word (Frame) * 17);
            Sensors := Numbered (Word (Frame) * 23);

            --  The link is also cut for some frames.
            Link_Is_Cut := Frame in 10 .. 13;
            Fly (1);
            Servos_Of (Processors) (Frame) := Servos;
            COREs_Of (Processors) (Frame) := CORE_Of_MCS;
         end loop;
         Expect ("overruns", MCS.Virtual_Time.Overruns, Before);
      end loop;
      for Frame in 1 .. Frames loop
         for Processors in Processor_Number loop
            Expect
              ("servos alike in frame" & Frame'Image & " on"
               & Processors'Image,
               Servos_Of (1) (Frame) = Servos_Of (Processors) (Frame), True);
            Expect
              ("CORE alike in frame" & Frame'Image & " on"
               & Processors'Image,
               COREs_Of (1) (Frame) = COREs_Of (Processors) (Frame), True);
         end loop;
      end loop;
      Expect
        ("the servos have moved", Servos_Of (2) (Frames) (1) > 16#200#, True);
   end More_Processors;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "INI-2 D-16 D-22 the test, then the condition's routine; none "
         & "after a failed test", Phases'Access);
      Add
        (Suite, "INI-1 INI-6 CORE and log count each warm start",
         Counted'Access);
      Add
        (Suite,
         "INI-3 INI-6 SAF-5 servos, CORE and log stay but at a cold start",
         Boards_Of_Aircraft'Access);
      Add
        (Suite, "INI-8 SAF-4 an order not taken is not taken after a start",
         Orders_Of_Both'Access);
      Add
        (Suite, "FTI-5 FTI-12 after a start no card is shown",
         Cards_Of_Aircraft'Access);
      Add
        (Suite, "FTI-9 a row has its frame's errors and all starts",
         Rows_Of_Aircraft'Access);
      Add
        (Suite, "FTI-10 no start answers a request that came before it",
         Requests_Of_Aircraft'Access);
      Add
        (Suite, "SAF-7 a start ends the row of the log under way",
         Rows_Under_Way'Access);
      Add
        (Suite, "SEC-3 a cold start ends a sealed session, no warm one does",
         Sessions_Of_Both'Access);
      Add
        (Suite, "INI-8 each start clears the aircraft's flags, a cold one "
         & "messages", Variables_Of_Aircraft'Access);
      Add
        (Suite, "INI-8 each start clears the ground's flags, a cold one "
         & "messages", Variables_Of_Ground'Access);
      Add
        (Suite, "INI-4 each start empties the transmit half",
         Transmit_Half'Access);
      Add
        (Suite, "SAF-4 each start forgets earlier input",
         Receive_Half'Access);
      Add
        (Suite, "INI-5 each start prepares the converter",
         Converters'Access);
      Add
        (Suite, "INI-7 the type codes are written again after each start",
         Codes_Again'Access);
      Add
        (Suite, "INI-3 INI-8 after a warm start the servos hold until a "
         & "command comes", Servos_Held'Access);
      Add
        (Suite, "INI-1 after a warm start at any tick all is well in five "
         & "frames", Flight_Goes_On'Access);
      Add
        (Suite, "INI-2 TST-4 an aircraft that fails its test says so and "
         & "does nothing", Silent_Aircraft'Access);
      Add
        (Suite, "INI-2 TST-4 a ground that fails its test is silent until "
         & "mended", Silent_Ground'Access);
      Add
        (Suite, "D-34 a processor restart flies on with a failed memory",
         Restarted_In_Flight'Access);
      Add
        (Suite, "KRN-6 a program that is broken off starts again",
         Broken_Off'Access);
      Add
        (Suite, "KRN-5 EXT-4 two to four processors give the results of one",
         More_Processors'Access);
   end Add_To;

end Starts_Tests;
