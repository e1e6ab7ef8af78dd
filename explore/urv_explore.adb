--  SPDX-License-Identifier: Apache-2.0

--  Explores both telemetry boards exhaustively: docs/exploration.md.
--  Exit status: 0 all is well; 1 something was found, and is printed.

with Ada.Command_Line; use Ada.Command_Line;
with Ada.Text_IO;      use Ada.Text_IO;
with Explore.Aircraft_Sides;
with Explore.Ground_Sides;
with Explore.Link;     use Explore.Link;
with Telemetry.Turns;

procedure URV_Explore is

   package Ground renames Explore.Ground_Sides;
   package Aircraft renames Explore.Aircraft_Sides;

   Is_Well   : Boolean := True;
   Calm      : Natural;
   After_Put : Natural;

   --  Says what a search has found.
   procedure Report (Name : String; Item : Findings);

   --  Says whether the normal form of a board loses nothing.
   procedure Report_Normal
     (Name : String; States : Natural; Is_Exact : Boolean);

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
     (Name : String; States : Natural; Is_Exact : Boolean) is
   begin
      Put_Line
        (Name & " board:" & States'Image & " full states, normal form "
         & (if Is_Exact then "exact" else "NOT EXACT"));
      Is_Well := Is_Well and Is_Exact;
   end Report_Normal;

   Found    : Findings;
   States   : Natural;
   Is_Exact : Boolean;
begin
   Put_Line
     ("dead space" & Telemetry.Turns.Dead_Space'Image & ", idle time"
      & Telemetry.Turns.Idle_Time'Image & ", frame"
      & Integer'Image (Explore.Frame) & " character times");

   Ground.Check_Normal (States, Is_Exact);
   Report_Normal ("ground", States, Is_Exact);
   Aircraft.Check_Normal (States, Is_Exact);
   Report_Normal ("aircraft", States, Is_Exact);

   Ground.Explore_Alone;
   Aircraft.Explore_Alone;
   Put_Line
     ("ground:" & Ground.Boards_Found'Image & " states of the board,"
      & Ground.Sides_Found'Image & " with the line");
   Put_Line
     ("aircraft:" & Aircraft.Boards_Found'Image & " states of the board,"
      & Aircraft.Sides_Found'Image & " with the line");
   Flush;

   Find_Quiet (Found, After_Put);
   Report ("back in step", Found);
   if Is_Well then
      Put_Line
        ("back in step: worst after the ground has a new block"
         & After_Put'Image & " character times");
      if Found.Worst > Explore.In_Step_Within
        or else After_Put >= Explore.Frame
      then
         Put_Line
           ("back in step: TOO LATE, promised within"
            & Integer'Image (Explore.In_Step_Within));
         Is_Well := False;
      end if;
   end if;

   if Is_Well then
      Calm := Found.Worst;
      Put_Line ("pairs in step:" & Calm_Pairs'Image);
      for Way in Direction loop
         Find_Delivery (Way, Found);
         Report
           ((if Way = Uplink then "fresh uplink" else "fresh downlink"),
            Found);
         if Found.Ends_Always then
            Put_Line
              ((if Way = Uplink then "fresh uplink" else "fresh downlink")
               & ": worst after the last fault"
               & Integer'Image (Calm + Found.Worst) & " character times,"
               & Integer'Image
                   ((Calm + Found.Worst + Explore.Frame - 1)
                    / Explore.Frame)
               & " major frames");
         end if;
      end loop;
   end if;

   Put_Line
     ("calls of the boards:"
      & Integer'Image (Ground.Calls_Made + Aircraft.Calls_Made));
   Put_Line (if Is_Well then "explored: all is well" else "explored: BAD");
   Set_Exit_Status (if Is_Well then Success else Failure);
end URV_Explore;
