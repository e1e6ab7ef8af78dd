--  SPDX-License-Identifier: Apache-2.0

--  Explores both telemetry boards exhaustively: docs/evidence/exploration.md.
--
--     urv_explore [UP DOWN [in-step [ROUND_TRIP]]]
--
--  UP and DOWN are the bytes of a block each way, 28 and 56 if nothing is
--  said; in-step leaves out the fresh blocks. Both boards wait for a line with
--  that round trip, in character times; 0 if nothing is said.
--  Exit status: 0 all is well; 1 something was found, and is printed; 2 the
--  arguments are wrong.

with Ada.Command_Line; use Ada.Command_Line;
with Ada.Exceptions;
with Ada.Text_IO;      use Ada.Text_IO;
with Explore.Aircraft_Sides;
with Explore.Ground_Sides;
with Explore.Link;     use Explore.Link;
with Telemetry;        use Telemetry;
with Telemetry.Headers;

procedure URV_Explore is

   package Ground renames Explore.Ground_Sides;
   package Aircraft renames Explore.Aircraft_Sides;

   Wrong_Argument : exception;

   --  The length of a block that an argument gives.
   function Length (Number : Positive) return Headers.Block_Length;

   --  The round trip that the last argument gives.
   function Round_Trip return Round_Trip_Time;

   --  Says what a search has found.
   procedure Report (Name : String; Item : Findings);

   --  Says whether the normal form of a board loses nothing.
   procedure Report_Normal
     (Name : String; Calls : Natural; Is_Exact : Boolean);

   procedure Explore_All;

   Is_Well : Boolean := True;

   function Length (Number : Positive) return Headers.Block_Length is
   begin
      for Value in Byte_Count loop
         if Value in Headers.Block_Length
           and then Byte_Count'Image (Value) = " " & Argument (Number)
         then
            return Value;
         end if;
      end loop;
      raise Wrong_Argument with
        """" & Argument (Number)
        & """ is no length of a block: 1, 2, 4, 28 or 56";
   end Length;

   function Round_Trip return Round_Trip_Time is
   begin
      for Value in Round_Trip_Time loop
         if Round_Trip_Time'Image (Value) = " " & Argument (4) then
            return Value;
         end if;
      end loop;
      raise Wrong_Argument with
        """" & Argument (4) & """ is no round trip: 0 to"
        & Round_Trip_Time'Last'Image;
   end Round_Trip;

   procedure Report (Name : String; Item : Findings) is
   begin
      Put_Line
        (Name & ":" & Item.States'Image & " states," & Item.Transitions'Image
         & " transitions");
      if Item.Ends_Always then
         Put_Line
           (Name & ": worst" & Item.Worst'Image & " character times");
      else
         Put_Line (Name & ": NEVER, this goes round for ever:");
         Print_Way;
         Is_Well := False;
      end if;
      Flush;
   end Report;

   procedure Report_Normal
     (Name : String; Calls : Natural; Is_Exact : Boolean) is
   begin
      Put_Line
        (Name & " board:" & Calls'Image & " calls, normal form "
         & (if Is_Exact then "exact" else "NOT EXACT"));
      Is_Well := Is_Well and Is_Exact;
   end Report_Normal;

   procedure Explore_All is
      Found    : Findings;
      In_Step  : Natural;
      Calls    : Natural;
      Is_Exact : Boolean;
   begin
      Ground.Explore_Alone;
      Aircraft.Explore_Alone;
      Put_Line
        ("ground:" & Ground.Boards_Found'Image & " states of the board,"
         & Ground.Sides_Found'Image & " with the line");
      Put_Line
        ("aircraft:" & Aircraft.Boards_Found'Image & " states of the board,"
         & Aircraft.Sides_Found'Image & " with the line");
      Flush;

      Find_Quiet (Found);
      Report ("back in step", Found);
      if not Is_Well then
         return;
      elsif Found.Worst > Explore.In_Step_Within then
         Put_Line
           ("back in step: TOO LATE, promised within"
            & Integer'Image (Explore.In_Step_Within));
         Is_Well := False;
         return;
      end if;
      In_Step := Found.Worst;
      Put_Line ("pairs in step:" & Calm_Pairs'Image);
      Flush;

      Ground.Check_Normal (1, Calls, Is_Exact);
      Report_Normal ("ground", Calls, Is_Exact);
      Aircraft.Check_Normal (1, Calls, Is_Exact);
      Report_Normal ("aircraft", Calls, Is_Exact);
      Flush;
      if not Is_Well or else Argument_Count in 3 | 4 then
         return;
      end if;

      for Way in Direction loop
         Find_Delivery (Way, Found);
         Report
           ((if Way = Uplink then "fresh uplink" else "fresh downlink"),
            Found);
         exit when not Is_Well;
         Put_Line
           ((if Way = Uplink then "fresh uplink" else "fresh downlink")
            & ": worst after the last fault"
            & Integer'Image (In_Step + Found.Worst) & " character times,"
            & Integer'Image
                ((In_Step + Found.Worst + Explore.Frame - 1)
                 / Explore.Frame)
            & " major frames");
         Flush;
      end loop;
   end Explore_All;

   --  The searches call themselves for every step of a way.
   task type Explorer with Storage_Size => 2 ** 30;

   task body Explorer is
   begin
      Explore_All;
      Put_Line
        ("calls of the boards:"
         & Integer'Image (Ground.Calls_Made + Aircraft.Calls_Made));
      Put_Line (if Is_Well then "explored: all is well" else "explored: BAD");
      Set_Exit_Status (if Is_Well then Success else Failure);
   exception
      when others =>
         Set_Exit_Status (Failure);
         raise;
   end Explorer;
begin
   if Argument_Count not in 0 | 2 | 3 | 4
     or else (Argument_Count in 3 | 4 and then Argument (3) /= "in-step")
   then
      raise Wrong_Argument with
        "usage: urv_explore [UP DOWN [in-step [ROUND_TRIP]]]";
   end if;
   if Argument_Count = 4 then
      Explore.Set_Round_Trip (Round_Trip);
   end if;
   if Argument_Count > 0 then
      Explore.Set_Lengths
        ((Telemetry.Ground   => Length (1),
          Telemetry.Aircraft => Length (2)));
   end if;
   Put_Line
     ("blocks of" & Explore.Length_Of (Telemetry.Ground)'Image & " and"
      & Explore.Length_Of (Telemetry.Aircraft)'Image & " bytes, dead space"
      & Character_Times'Image (Dead_Space_On (Explore.Round_Trip))
      & ", idle time"
      & Character_Times'Image (Idle_Time_On (Explore.Round_Trip)) & ", frame"
      & Integer'Image (Explore.Frame) & " character times");
   Flush;

   declare
      Unused : Explorer;
   begin
      null;
   end;
exception
   when Error : Wrong_Argument =>
      Put_Line
        (Standard_Error,
         "urv_explore: " & Ada.Exceptions.Exception_Message (Error));
      Set_Exit_Status (2);
end URV_Explore;
