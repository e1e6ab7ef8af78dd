--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Handling;
with Ada.Exceptions;
with Ada.Strings.Unbounded;
with GNAT.OS_Lib;

with Host;                  use Host;
with Host.Complaints;
with Host.Event_Log;
with Host.Key_Files;
with Host.Names;
with Host.Option_Help;
with Host.Options;          use Host.Options;
with Host.Outputs;
with Host.Text_Numbers;
with Host.Text_Output;
with Host.Truth_Columns;
with Partitions.Clocks;
with Partitions.Exceptions;
with Partitions.Links;
with Partitions.Measurements; use Partitions.Measurements;
with Partitions.Notes;
with Partitions.Occurrences;
with Partitions.Output_Files; use Partitions.Output_Files;
with Partitions.Peer_Watch; use Partitions.Peer_Watch;
with Partitions.Permission;
with Partitions.Reports;
with Partitions.Round_Trips;
with Partitions.Rows;       use Partitions.Rows;
with Partitions.Signal_Masks;
with Telemetry.Boards;
with URV.Errors;
with URV.Handshakes;
with URV.Sessions;
with URVOS;
with URVOS.Frames;

procedure Partitions.Run is

   use type URV.Handshakes.Format_Number;
   use Host.Text_Output;
   use type Number;
   use type URVOS.Count;

   Frames : Number := 0;
   Chosen : Choices;
   Whole  : Exchange_Watch;

   --  The text for the current output: for the help, directly the screen.
   Screen : Writer;
   Page   : Writer;

   Keys   : Host.Key_Files.Key_Ring;

   --  In the whole run this node took no block.
   Carried_Nothing : Boolean := False;

   --  The exit status then.
   Nothing_Carried : constant := 3;

   --  The blocks that this node sends and receives.
   Sent     : constant String :=
     (if This = Ground then "uplink" else "downlink");
   Received : constant String :=
     (if This = Ground then "downlink" else "uplink");

   Program : constant Host.Options.Program :=
     (if This = Ground then URV_GSC else URV_MCS);

   --  The program's name, as it is called.
   Title : constant String :=
     Ada.Characters.Handling.To_Lower (Program'Image);

   --  Prints the usage.
   procedure Print_Usage;

   --  Prints a line on the terminal.
   procedure Note (Message : String);

   --  Hundredths of a second, without trailing zeros.
   function Seconds (Of_Frames : Number) return String;

   function Number_Of (Total : URVOS.Count; Message : String) return String is
     (Host.Text_Numbers.Image (Long_Long_Integer (Total)) & " " & Message
      & (if Total = 1 then "" else "s"));

   procedure Seal_Node (Given : URV.Sessions.Key_List);

   --  Each reports new events.
   procedure Report_Peer (State : Peer_State);
   procedure Report_Refusals;
   procedure Report_Starts;
   procedure Report_Left_Out;
   procedure Report_Fault;

   --  Reports new events of the other node, in that state, and of this one.
   procedure Look_Around (State : Peer_State);

   --  The partition ends. Its other tasks do not: Ravenscar.
   procedure Leave (Status : Integer) with No_Return;

   --  Writes a row for each frame until the partition is switched off.
   procedure Take_Rows (Last_Frame : Number);

   --  The node's counts at one instant: the node continues while outputs are
   --  written, but all figures of a run must agree.
   type Totals is record
      Log      : URV.Errors.Error_Log;
      Link     : Telemetry.Boards.Statistics;
      Peer     : Peer_State;
      Refused  : URVOS.Count;
      Overruns : URVOS.Count;
   end record;

   function Counted return Totals is
     ((Log      => This_Node.Log,
       Link     => This_Node.Link_Tally,
       Peer     => This_Node.Peer,
       Refused  => This_Node.Refused,
       Overruns => This_Node.Overruns));

   --  When they were last written.
   Total : Totals;

   --  During the run without the tasks' durations: their sums would take the
   --  node's time.
   procedure Write_Summary (Is_Over : Boolean);

   --  The summary and the events, of one moment: the node flies on. During the
   --  run it skips outputs that cannot be rewritten.
   procedure Write_Counts (Is_Over : Boolean);

   --  Writes all results to the files, each second of the run: they remain if
   --  the program is killed.
   procedure Keep_Results;

   --  Puts the new rows of the flight recorder (FTI-11). They are written each
   --  quarter of a second, so that with the disk's time a power cut costs less
   --  than a second of them. A slow file's rows stay aboard until it has room.
   procedure Take_Recording;

   --  Puts the rows that are still aboard.
   procedure Finish_Recording;

   procedure Print_Summary;

   procedure Print_Usage is
      A_Dead_Plant : constant String :=
        (if This = Ground then "" else ", a dead plant");
   begin
      Put_Line
        (Screen,
         "usage: " & Title & " --link LINK [options]");
      Put_Line (Screen, "       " & Title & " --version");
      New_Line (Screen);
      Put_Line
        (Screen,
         "Runs the " & (if This = Ground then "ground station core"
                        else "aircraft's control system")
         & " in real time, until SIGINT or SIGTERM.");
      Put_Line
        (Screen,
         "SIGUSR1 raises a processor exception, SIGUSR2 presses the reset"
         & " switch.");
      New_Line (Screen);
      Host.Option_Help.Print (Screen, Program);
      New_Line (Screen);
      Put_Line
        (Screen,
         "Exit status: 0 run; 2 a bad command line, input file or link;");
      Put_Line
        (Screen,
         "1 an output was lost, an internal fault" & A_Dead_Plant
         & ";");
      Put_Line (Screen, "3 run, but the other node was never heard");
   end Print_Usage;

   procedure Note (Message : String) is
   begin
      if not Chosen.Quiet then
         Notes.Print (Message);
      end if;
   end Note;

   function In_Hundredths (Of_Frames : Number) return Number is
     (Of_Frames * Frame_Length * 100 / Microseconds_Per_Second);

   function Seconds (Of_Frames : Number) return String is
      use Host.Text_Numbers;
      Hundredths : constant Rows.Number := In_Hundredths (Of_Frames);
      Rest       : constant Rows.Number := Hundredths mod 100;
   begin
      return
        Image (Long_Long_Integer (Hundredths / 100))
        & (if Rest = 0 then ""
           elsif Rest < 10 then ".0" & Image (Long_Long_Integer (Rest))
           elsif Rest mod 10 = 0
           then "." & Image (Long_Long_Integer (Rest / 10))
           else "." & Image (Long_Long_Integer (Rest)));
   end Seconds;

   --  The last reported states. Used by the environment task.
   Reported_Peer    : Peer_State := Never_Heard;
   Reported_Refused : URVOS.Count := 0;
   Refused_Frame    : Number := 0;
   Reported_Missing : array (Growing) of URVOS.Count := (others => 0);
   Missing_Frame    : array (Growing) of Number := (others => 0);
   Fault_Reported   : Boolean := False;
   Reported_Pauses  : URVOS.Count := 0;
   Reported_Starts  :
     array (URV.Errors.Error_Kind range URV.Errors.Warm_Reset
                                     .. URV.Errors.Processor_Restart)
     of URVOS.Count := (others => 0);

   --  The shortest time between two reports of a flood of refused blocks, or
   --  of rows that are left out.
   Refusals_Every : constant Number :=
     5 * Microseconds_Per_Second / Frame_Length;

   procedure Report_Peer (State : Peer_State) is
   begin
      if State = Is_Heard and then Reported_Peer /= Is_Heard then
         Note ("peer heard at " & Seconds (Frames) & " s");
      elsif State = Is_Lost and then Reported_Peer = Is_Heard then
         Note
           ("peer lost at " & Seconds (Frames)
            & " s: no good message for 1 s");
      end if;
      Reported_Peer := State;
   end Report_Peer;

   procedure Report_Refusals is
      Refused : constant URVOS.Count := This_Node.Refused;
   begin
      if Refused > Reported_Refused
        and then (Reported_Refused = 0
                  or else Frames >= Refused_Frame + Refusals_Every)
      then
         Note
           (Number_Of (Refused, "block") & " refused by "
            & Seconds (Frames)
            & " s: of another key or format, or not the peer's");
         Reported_Refused := Refused;
         Refused_Frame := Frames;
      end if;
   end Report_Refusals;

   procedure Report_Starts is
      use URV.Errors;
      Log    : constant Error_Log   := This_Node.Log;
      Paused : constant URVOS.Count := This_Node.Pauses;
      Found  : URVOS.Count;
   begin
      for Kind in Reported_Starts'Range loop
         Found := Logs.History_Of (Log, Kind).Occurrences;

         --  The restart of a stopped node is reported below.
         if Kind = Processor_Restart then
            Found := URVOS.Count'Max (Found - Paused, 0);
         end if;
         if Found > Reported_Starts (Kind) then
            Note
              ((if Kind = Warm_Reset then "warm reset"
                else "processor restart")
               & " by " & Seconds (Frames) & " s");
            Reported_Starts (Kind) := Found;
         end if;
      end loop;
   end Report_Starts;

   procedure Report_Left_Out is
      Missing : URVOS.Count;
   begin
      for Output in Growing loop
         Missing := Rows_Left_Out (Output);
         if Missing > Reported_Missing (Output)
           and then not Is_Lost (Output)
           and then (Reported_Missing (Output) = 0
                     or else Frames >= Missing_Frame (Output) + Refusals_Every)
         then
            Note
              (Name (Output) & ": " & Number_Of (Missing, "row")
               & " left out by " & Seconds (Frames)
               & " s: the file is too slow");
            Reported_Missing (Output) := Missing;
            Missing_Frame (Output) := Frames;
         end if;
      end loop;
   end Report_Left_Out;

   procedure Report_Fault is
   begin
      if Exceptions.Number > 0 and then not Fault_Reported then
         Notes.Print
           ("internal fault by " & Seconds (Frames) & " s: "
            & Exceptions.First);
         Fault_Reported := True;
      end if;
   end Report_Fault;

   procedure Look_Around (State : Peer_State) is
      Tally     : constant Telemetry.Boards.Statistics := This_Node.Link_Tally;
      Is_Broken : Boolean;
      Changed   : Boolean;
   begin
      Report_Peer (State);
      Report_Refusals;
      Report_Starts;
      Report_Left_Out;
      Report_Fault;
      declare
         Message : constant String :=
           Round_Trips.Next_Message (Seconds (Frames));
      begin
         if Message /= "" then
            Note (Message);
         end if;
      end;
      Look
        (Whole,
         Begun     =>
           (if This = Ground then Round_Trips.Heard else Tally.Received),
         Ended     => (if This = Ground then Tally.Received else Tally.Sent),
         Frame     => Frames,
         Is_Broken => Is_Broken,
         Changed   => Changed);
      if Changed then
         Note
           (if not Is_Broken
            then "exchanges are whole again at " & Seconds (Frames) & " s"
            elsif This = Ground
            then "the aircraft sends no downlink at " & Seconds (Frames)
                 & " s, though it answers: it has none, or the line is too"
                 & " slow for the --line-delay of both nodes"
            else "the ground asks for no downlink at " & Seconds (Frames)
                 & " s, though its uplinks come: it does not hear this node,"
                 & " or too late for its --line-delay");
      end if;
      declare
         Message : constant String :=
           Surroundings.Next_Message (Seconds (Frames));
      begin
         if Message /= "" then
            Note (Message);
         end if;
      end;
      if This_Node.Pauses > Reported_Pauses then
         Reported_Pauses := This_Node.Pauses;
         Note
           ("stood still before " & Seconds (Frames)
            & " s: the processor was restarted");
      end if;
   end Look_Around;

   procedure Leave (Status : Integer) is
   begin
      Notes.Finish;
      Surroundings.Stop;
      GNAT.OS_Lib.OS_Exit (Status);
   end Leave;

   Frames_Between : constant := Flush_Interval / Frame_Length;

   procedure Keep_Results is
   begin
      Write_Counts (Is_Over => False);
      for Output in Growing loop
         if Is_Open (Output) then
            Write_Rows (Output);
         end if;
      end loop;
   end Keep_Results;

   procedure Take_Recording is
   begin
      if Is_Open (Recording_Option) and then Has_Room (Recording_Option) then
         Clear (Page);
         Surroundings.Put_Recording (Page);
         Put_Row (Text (Page), Recording_Option);
      end if;
   end Take_Recording;

   procedure Finish_Recording is
   begin
      while Is_Open (Recording_Option) loop
         Clear (Page);
         Surroundings.Put_Recording (Page);
         exit when Text (Page) = "";
         Put_Row (Text (Page), Recording_Option);
      end loop;
      Report_Left_Out;
   end Finish_Recording;

   procedure Take_Rows (Last_Frame : Number) is
      Item  : Row;
      Found : Boolean;
   begin
      loop
         Await (Item, Found);
         exit when not Found;
         Frames := Item.Value (1) + 1;
         Look_Around (Item.Peer);
         if Is_Open (Record_Option) then
            Clear (Page);
            for Place in 1 .. Item.Length loop
               if Place > 1 then
                  Put (Page, ',');
               end if;
               Put (Page, Item.Value (Place));
            end loop;
            if Item.Has_Truth then
               Host.Truth_Columns.Put_Values (Page, Item.Truth);
            end if;
            New_Line (Page);
            Put_Row (Text (Page));
         end if;
         Take_Recording;
         exit when Last_Frame > 0 and then Frames >= Last_Frame;
         if Frames mod Frames_Between = 1 then
            Keep_Results;
         elsif Is_Open (Recording_Option)
           and then Frames mod (Frames_Between / 4) = 0
         then
            Write_Rows (Recording_Option);
         end if;
      end loop;
      Queue.Finish;
   end Take_Rows;

   --  The tasks' durations, and the error log.
   procedure Put_Results
     (Result : in out Reports.Report;
      To     : in out Writer;
      Log    : URV.Errors.Error_Log);

   --  The distributions of each task.
   procedure Put_Distributions
     (Result : in out Reports.Report;
      To     : in out Writer;
      Title  : String;
      Item   : in out This_Node.Distributions);

   procedure Put_Distributions
     (Result : in out Reports.Report;
      To     : in out Writer;
      Title  : String;
      Item   : in out This_Node.Distributions) is
   begin
      Reports.Begin_Group (Result, To, Title);
      for Which in Item'Range loop
         Reports.Put_Times
           (Result, To, Ada.Characters.Handling.To_Lower (Which'Image),
            Item (Which).Summed_Up);
      end loop;
      Reports.End_Group (Result, To);
   end Put_Distributions;

   procedure Put_Results
     (Result : in out Reports.Report;
      To     : in out Writer;
      Log    : URV.Errors.Error_Log) is
   begin
      Reports.Put_Times
        (Result, To, "release_jitter_us", This_Node.Lateness.Summed_Up);
      Put_Distributions (Result, To, "cost_us", This_Node.Costs);
      Put_Distributions (Result, To, "response_us", This_Node.Responses);
      Reports.Put_Log (To, Result, Log);
   end Put_Results;

   procedure Write_Summary (Is_Over : Boolean) is
      Tally  : Telemetry.Boards.Statistics renames Total.Link;
      Result : Reports.Report;
      To     : Writer renames Page;
      Lost   : Ada.Strings.Unbounded.Unbounded_String;
   begin
      Reports.Begin_Report (Result, To);
      if not Is_Over then
         Reports.Put_Field (Result, To, "unfinished", Number'(1));
      end if;
      Reports.Put_Field (Result, To, "seconds", In_Hundredths (Frames), 2);
      Reports.Put_Field (Result, To, "frames", Frames);
      Reports.Put_Field
        (Result, To, "overruns", Number (Total.Overruns));
      Reports.Put_Field
        (Result, To, "switched_on_us",
         Number (Clocks.Machine_Time (Clocks.Switched_On_At)));
      Reports.Put_Field
        (Result, To, "characters_not_sent", Number (Links.Not_Sent));
      Reports.Put_Field
        (Result, To, "rows_left_out",
         Number (Queue.Left_Out) + Number (Rows_Left_Out (Record_Option))
         + Number (Rows_Left_Out (Recording_Option)));
      for Output in Kept loop
         if Output_Files.Is_Lost (Output) then
            Reports.Add_Name (Lost, Name (Output));
         end if;
      end loop;
      Reports.Put_Names (Result, To, "lost_outputs", Lost);
      Reports.Begin_Group (Result, To, "link");
      Reports.Put_Field (Result, To, "state", Name (Total.Peer));
      Reports.Put_Field (Result, To, Sent & "_sent", Number (Tally.Sent));
      Reports.Put_Field
        (Result, To, Sent & "_scrapped", Number (Tally.Scrapped));
      Reports.Put_Field
        (Result, To, Received & "_received", Number (Tally.Received));
      Reports.Put_Field
        (Result, To, Received & "_bad", Number (Tally.Bad));
      Reports.Put_Field
        (Result, To, "blocks_refused", Number (Total.Refused));
      Reports.Put_Field (Result, To, "resets", Number (Tally.Resets));
      Reports.Put_Field
        (Result, To, "board_restarts", Number (This_Node.Board_Starts));
      Reports.Put_Field
        (Result, To, "bytes_discarded", Number (Links.Discarded));
      Reports.Put_Field
        (Result, To, "line_delay_us", Number (Chosen.Line_Delay));
      Reports.Put_Times
        (Result, To, "round_trip_us", Round_Trips.Measured);
      Reports.Put_Field
        (Result, To, "late_answers", Number (Round_Trips.Late));
      Reports.End_Group (Result, To);
      Reports.Put_Field (Result, To, "stood_still", Number (This_Node.Pauses));
      Reports.Put_Field
        (Result, To, "exceptions", Number (Exceptions.Number));
      Reports.Put_Field
        (Result, To, "real_time_priorities",
         Number (Boolean'Pos (Permission.Is_Granted)));
      Surroundings.Put_Counts (Result, To);
      if Is_Over then
         Put_Results (Result, To, Total.Log);
      end if;
      Reports.End_Report (Result, To);
   end Write_Summary;

   function Time_Of (Now : URVOS.Frames.Clock_Tick) return Microseconds is
     (Microseconds (Now) * Tick_Time);

   procedure Write_Log is new Host.Event_Log.Write (Time_Of);

   procedure Write_Counts (Is_Over : Boolean) is
      use type Peer_State;

      function Is_Written (Output : Kept) return Boolean is
        (Is_Open (Output) and then (Is_Over or else Can_Restart (Output)));

   begin
      Total := Counted;
      Carried_Nothing := Total.Peer = Never_Heard;
      if Is_Over then
         Occurrences.Finish;
      end if;
      if Is_Written (Events_Option) then
         Clear (Page);
         Write_Log (Page, Host.Names.Name (This), Total.Log);
         Surroundings.Put_Events (Page);
         Put_Version (Events_Option, Text (Page));
      end if;
      if Is_Over then
         --  A loss is known only after the write.
         Finish (Record_Option);
         Finish (Recording_Option);
         Finish (Events_Option);
      end if;
      if Is_Written (Summary_Option) then
         Clear (Page);
         Write_Summary (Is_Over);
         Put_Version (Summary_Option, Text (Page));
      end if;
   end Write_Counts;

   procedure Print_Summary is
      use Host.Text_Numbers;

      Tally : Telemetry.Boards.Statistics renames Total.Link;
      Times : constant Statistics := Round_Trips.Measured;
   begin
      Clear (Page);
      Put_Line
        (Page,
         "run       " & Seconds (Frames) & " s, "
         & Image (Long_Long_Integer (Frames)) & " frames, "
         & Image (Long_Long_Integer (Total.Overruns)) & " overruns");
      Put_Line
        (Page,
         "link      peer " & Name (Total.Peer) & ", "
         & Number_Of (Tally.Sent, Sent) & " sent, "
         & Image (Long_Long_Integer (Tally.Scrapped)) & " scrapped, "
         & Number_Of (Tally.Received, Received) & " received, "
         & Image (Long_Long_Integer (Tally.Bad)) & " bad, "
         & Number_Of (Tally.Resets, "reset") & ", "
         & Image (Long_Long_Integer (Total.Refused)) & " refused"
         & (if Times.Number = 0 then ""
            else ", round trip " & Round_Trips.Image (Times.Median)
                 & " ms"));
      if Host.Outputs.Use_Standard_Output (Chosen) then
         Notes.Print_Lines (Text (Page));
      else
         Print (Text (Page));
         Finish_Printing;
      end if;
   end Print_Summary;

   procedure Seal_Node (Given : URV.Sessions.Key_List) is
   begin
      This_Node.Seal_Link (2, Given, Host.Key_Files.Random_Nonce);
   end Seal_Node;

   procedure Seal_Link is new Host.Key_Files.Hand_Over (Seal_Node);

begin
   Chosen := Parsed (Program, First => 1);
   if Chosen.Wants_Help or else Chosen.Wants_Version then
      Attach_Screen (Screen);
      if Chosen.Wants_Help then
         Print_Usage;
      else
         Put_Line (Screen, Title & ' ' & Host.Version);
      end if;
      Close (Screen);
      Leave (if Host.Text_Output.Any_Lost then 1 else 0);
   end if;

   if Chosen.Format = 2 then
      Host.Key_Files.Load (Keys, Value (Chosen, Key_Option));
      Seal_Link (Keys);
   end if;
   Signal_Masks.Let_End;
   Surroundings.Prepare (Chosen);
   Links.Open (Value (Chosen, Link_Option));
   Output_Files.Open (Chosen);
   Signal_Masks.Block;
   Attach_Memory (Page);
   if Is_Open (Record_Option) then
      Put
        (Page,
         "frame,time_ms" & Contents.Column_Names & ",overruns,clock_us"
         & Contents.Last_Names);
      if Contents.Has_Truth then
         Host.Truth_Columns.Put_Names (Page);
      end if;
      New_Line (Page);
      Put_Row (Text (Page));
   end if;

   if Is_Given (Chosen, Phase_Option) then
      Clocks.Await_Phase (Chosen.Phase);
   end if;
   Note ("listening at " & Value (Chosen, Link_Option));
   if not Permission.Is_Granted then
      Note (Permission.How_To_Grant);
   end if;
   Clocks.Switch_On;
   This_Node.Switch_On
     (Chosen.Processors, Chosen.Schedule, Chosen.Line_Delay);
   Take_Rows
     (Last_Frame => Number (Whole_Frames (Chosen.Length) / Major_Frame));
   Finish_Recording;

   Write_Counts (Is_Over => True);
   Finish (Summary_Option);
   if not Chosen.Quiet then
      Print_Summary;
   end if;
   if Surroundings.Failure /= "" then
      Notes.Print (Surroundings.Failure);
      Leave (1);
   end if;
   if Exceptions.Number > 0 then
      Notes.Print ("internal fault: " & Exceptions.First);
      Leave (1);
   end if;
   if Output_Files.Any_Lost then
      Leave (1);
   end if;
   Leave (if Carried_Nothing then Nothing_Carried else 0);

exception
   when Error : Host.Bad_Input =>
      Host.Complaints.Print (Error);
      Leave (Host.Complaints.Exit_Status);

   when Error : others =>
      Notes.Print
        ("internal fault: " & Ada.Exceptions.Exception_Information (Error));
      Leave (1);
end Partitions.Run;
