--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time;
with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with GSC;
with Host.Complaints;
with Host.Pilot;
with Host.Stick_Scripts;      use Host.Stick_Scripts;
with Partitions.Clocks;
with Partitions.Columns;      use Partitions.Columns;
with Partitions.Console_Port; use Partitions.Console_Port;
with Partitions.Occurrences;
with Partitions.Orders;
with Telemetry.Boards;
with URV.Console_Watch;
with URV.CORE_Memory;
with URV.Law_Status;
with URV.Routing;

package body Partitions.Console is

   Script : Host.Stick_Scripts.Script;

   Has_Pilot : Boolean := False;

   --  The words for safe outputs (D-13).
   Safe_Words : constant Console_Words :=
     (Throttle    => Neutral_Uplink (Throttle),
      Brake       => Neutral_Uplink (Brake),
      Switch_Item => 0,
      others      => Neutral_Value);

   --  Judges a silent console. Used by the converter only.
   Watch : URV.Console_Watch.Watch;

   --  The time that the simulated pilot has flown. Used by the converter only.
   Flown : Microseconds := 0;

   --  Read by the controller's tasks for the record, set by the converter.
   protected Present is
      procedure Set (This : Sticks);
      function Get return Sticks;
   private
      Held : Sticks;
   end Present;

   protected body Present is

      procedure Set (This : Sticks) is
      begin
         Held := This;
      end Set;

      function Get return Sticks is (Held);

   end Present;

   Helds    : Occurrences.Occurrence;
   Neutrals : Occurrences.Occurrence;

   --  Used by the task that takes the record's rows.
   In_Row : Sticks;

   --  Used by the environment task.
   Reported        : Sticks;
   Reported_Orders : URVOS.Count := 0;

   --  Applies the script's rows up to now.
   procedure Follow_Script (This : in out Sticks);

   --  Frames of silence.
   function Frames_In (Silence : Ada.Real_Time.Time_Span)
                       return URV.Console_Watch.Frame_Count;

   --  Takes the words of the console's packets. A lost console's last words
   --  stay.
   procedure Follow_Port (This : in out Sticks; Pilot_Wanted : out Boolean);

   --  The pilot flies, or watches.
   procedure Ask_Pilot (This : in out Sticks; Pilot_Wanted : Boolean);

   use type URVOS.Count;

   procedure Load (File : String) is
   begin
      Load (Script, File);
   end Load;

   procedure Take_Aboard (Pilot_Flight : String) is
   begin
      if not Host.Pilot.Exists (Pilot_Flight)
        or else Host.Pilot.Is_By_Eye (Pilot_Flight)
      then
         Complaints.Refuse
           ("--pilot: " & Complaints.Quoted (Pilot_Flight)
            & " is not a flight the pilot knows; there are "
            & Host.Pilot.Names (By_Eye => False));
      end if;
      Host.Pilot.Start (Pilot_Flight);
      Has_Pilot := True;
   end Take_Aboard;

   procedure Follow_Script (This : in out Sticks) is
   begin
      while Next_Time (Script) <= Clocks.Elapsed loop
         Advance (Script, This.Words);
      end loop;
   end Follow_Script;

   function Frames_In (Silence : Ada.Real_Time.Time_Span)
                       return URV.Console_Watch.Frame_Count
   is
      use Ada.Real_Time;
      use URV.Console_Watch;

      Frame   : constant Time_Span :=
        Ada.Real_Time.Microseconds (Integer (Major_Frame));
      Longest : constant Time_Span := Frame * Integer (Frame_Count'Last);
   begin
      return
        (if Silence >= Longest then Frame_Count'Last
         else Frame_Count (Silence / Frame));
   end Frames_In;

   procedure Follow_Port (This : in out Sticks; Pilot_Wanted : out Boolean) is
      Now : constant Situation := Seen (Ada.Real_Time.Clock);
      Was : constant Console_State := This.State;
   begin
      Watch := URV.Console_Watch.Next
        (Watch, Frames_In (Now.Silence),
         URV.Console_Watch.Downlink_Of (GSC.CORE_Memory.Contents.Downlink));
      case Watch.Input is
         when URV.Console_Watch.Live =>
            This.State := Live;
            This.Words := Now.Words;
            This.Sequence := Now.Sequence;
         when URV.Console_Watch.Held =>
            This.State := Held;
            This.Sequence := Now.Sequence;
            This.Words := (if Now.Has_Come then Now.Words else Safe_Words);
         when URV.Console_Watch.Safe_Words =>
            This.State := Neutral;
            This.Words := Safe_Words;
            This.Sequence := 0;
      end case;
      if Now.Has_Come and then This.State /= Was then
         if This.State = Held then
            Helds.Add (Clocks.Elapsed);
         elsif This.State = Neutral then
            Neutrals.Add (Clocks.Elapsed);
         end if;
      end if;
      This.Has_Come := Now.Has_Come;
      Pilot_Wanted := Now.Pilot_Flies;
   end Follow_Port;

   procedure Ask_Pilot (This : in out Sticks; Pilot_Wanted : Boolean) is
      Shown : constant Downlink_Buffer :=
        GSC.CORE_Memory.Contents.Downlink;
   begin
      if Pilot_Wanted then
         Host.Pilot.Move (Flown, Shown, This.Words);
         Flown := Flown + Major_Frame;
         This.Pilot := Flies;
         This.Sequence := 0;
      else
         Host.Pilot.Watch (Shown);
         This.Pilot := Hands_Off;
      end if;
   end Ask_Pilot;

   procedure Sample
     (Is_Next  : Boolean;
      Words    : out Channel_Words;
      Is_There : out Boolean)
   is
      pragma Unreferenced (Is_Next);   --  the ground scans once a frame
      This         : Sticks  := Present.Get;
      Pilot_Wanted : Boolean := True;
   begin
      if Console_Port.Is_Open then
         Follow_Port (This, Pilot_Wanted);
      elsif not Has_Pilot then
         Follow_Script (This);
      end if;
      if Has_Pilot then
         Ask_Pilot (This, Pilot_Wanted);
      end if;
      Present.Set (This);
      Orders.Send_Due;
      Is_There := This.State /= Held or else This.Pilot = Flies;

      Words := (others => Neutral_Value);
      for Command in Command_Item loop
         Words (URV.Routing.Channel_Of (Command)) := This.Words (Command);
      end loop;
   end Sample;

   function Column_Names return String is
     (Console_Names ("console") & Uplink_Names ("gsc.uplink")
      & Downlink_Names ("gsc.downlink")
      & ",link.uplink_sent,link.uplink_scrapped,link.downlink_received"
      & ",link.downlink_bad,link.gsc_resets");

   procedure Append_Values (To : in out Row) is
      CORE  : constant URV.CORE_Memory.Memory  :=
        GSC.CORE_Memory.Contents;
      Tally : constant Telemetry.Boards.Statistics :=
        GSC.Telemetry_Board.Tally;
   begin
      In_Row := Present.Get;
      Append_Console (To, In_Row.Words);
      Append_Uplink (To, CORE.Uplink);
      Append_Downlink (To, CORE.Downlink);
      Append_Counts
        (To,
         (Tally.Sent, Tally.Scrapped, Tally.Received, Tally.Bad,
          Tally.Resets));
   end Append_Values;

   function Law_Names return String is
     (",laws.told,laws.told_invalid_low,laws.told_invalid_high"
      & ",laws.told_silent,laws.told_failed,laws.told_configuration"
      & Frame_Names ("gsc.frame"));

   procedure Append_Laws (To : in out Row) is
      use URV.Law_Status;

      CORE   : constant URV.CORE_Memory.Memory := GSC.CORE_Memory.Contents;
      Status : constant Report := From_Row (CORE.Aircraft_Log (Row_Number));
   begin
      for Item in Active .. Failed loop
         Append (To, Number (Status (Item)));
      end loop;
      Append (To, Number (Status (Configuration)));
      Append_Frame (To, CORE.Frame);
   end Append_Laws;

   function Recorded return Sticks is (In_Row);

   function Times_Held return URVOS.Count is (Helds.Contents.Number);

   function Times_Neutral return URVOS.Count is (Neutrals.Contents.Number);

   function Next_Message (Now : String) return String is
      This     : constant Sticks := Present.Get;
      Messages : Unbounded_String;

      procedure Append_Message (Message : String; Why : String := "");

      procedure Append_Message (Message : String; Why : String := "") is
      begin
         Append (Messages, (if Messages = "" then "" else "; "));
         Append (Messages, Message & " at " & Now & " s" & Why);
      end Append_Message;

   begin
      if This.State /= Reported.State then
         case This.State is
            when No_Console => null;
            when Live       => Append_Message ("console live");
            when Held       =>
               Append_Message
                 ("console held",
                  ": no packet "
                  & (if This.Has_Come then "for 0.5 s" else "yet")
                  & (if This.Pilot = Flies then ", the simulated pilot flies"
                     else ", nothing fresh goes up"));
            when Neutral    =>
               Append_Message
                 ("console neutral",
                  ": no packet "
                  & (if This.Has_Come then "for 2 s" else "yet")
                  & ", the aircraft is on the ground");
         end case;
      end if;
      if This.Pilot /= Reported.Pilot then
         case This.Pilot is
            when No_Pilot  => null;
            when Hands_Off => Append_Message ("pilot hands off");
            when Flies     => Append_Message ("pilot flies");
         end case;
      end if;
      Reported := This;
      if Orders.Sent > Reported_Orders then
         Reported_Orders := Orders.Sent;
         Append_Message ("order" & Reported_Orders'Image & " sent up");
      end if;
      return To_String (Messages);
   end Next_Message;

   procedure Put_Events (To : in out Host.Text_Output.Writer) is
   begin
      Occurrences.Write (To, Ground, "console_held", Helds.Contents);
      Occurrences.Write (To, Ground, "console_neutral", Neutrals.Contents);
   end Put_Events;

end Partitions.Console;
