--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Handling; use Ada.Characters.Handling;
with Ada.Command_Line;        use Ada.Command_Line;
with Ada.Strings.Fixed;       use Ada.Strings.Fixed;
with Ada.Strings.Maps;        use Ada.Strings.Maps;

with Host.Complaints;   use Host.Complaints;
with Host.Key_Files;
with Host.Pilot;
with Host.Text_Numbers; use Host.Text_Numbers;

package body Host.Options is

   use URVOS.Task_Trees;

   type Option_Set is array (Option) of Boolean;

   --  Finds the option of that name, or refuses it.
   function Option_Of (Caller : Program; Title : String) return Option;

   --  Stores an option's value in the choices.
   procedure Choose
     (Chosen : in out Choices;
      Which  : Option;
      Value  : String);

   --  Adds another destination of the published packets.
   procedure Add_Place (Chosen : in out Choices; Place : Unbounded_String);

   --  Refuses options that exclude each other, and a missing one.
   procedure Check (Caller : Program; Chosen : Choices);

   function Name (Which : Option) return String is
      Image : constant String := To_Lower (Which'Image);
      Kind  : constant String := "_option";
   begin
      return
        "--"
        & Translate
            (Image (Image'First .. Image'Last - Kind'Length),
             To_Mapping ("_", "-"));
   end Name;

   function Value_Name (Which : Option) return String is
     (case Which is
         when Link_Option                      => "LINK",
         when Seconds_Option | Orbit_After_Option
            | Terminate_After_Option
            | Recorder_Option                  => "S",
         when Plant_Option                     => "PLANT",
         when Pilot_Option | Schedule_Option   => "NAME",
         when Phase_Option                     => "TICKS",
         when Drift_Option                     => "PPM",
         when Line_Delay_Option                => "MS",
         when Laws_Option                      => "LAWS",
         when Pace_Option                      => "PACE",
         when Seed_Option | Processors_Option
            | Format_Option | Packets_Option   => "N",
         when Sticks_Option | Sensors_Option .. Orders_Option
            | Key_Option | Output_Option       => "FILE",
         when Console_Option | Publish_Option  => "udp:HOST:PORT",
         when Lock_Option | Quiet_Option       => "");

   function Option_Of (Caller : Program; Title : String) return Option is
      Names : Unbounded_String;
   begin
      for Which in Option loop
         if Has (Caller, Which) then
            if Name (Which) = Title then
               return Which;
            end if;
            Append (Names, (if Names = "" then "" else ", ") & Name (Which));
         end if;
      end loop;
      if Title'Length > 1 and then Title (Title'First) = '-' then
         Refuse
           ("unknown option " & Quoted (Title) & "; there are "
            & To_String (Names));
      else
         Refuse ("unexpected argument " & Quoted (Title));
      end if;
   end Option_Of;

   procedure Choose
     (Chosen : in out Choices;
      Which  : Option;
      Value  : String)
   is
      Title : constant String := Name (Which);
   begin
      Chosen.Values (Which) := To_Unbounded_String (Value);
      case Which is
         when Seconds_Option =>
            Chosen.Length := Time_Of (Title, Value, Longest_Time);
         when Plant_Option =>
            Chosen.Plant :=
              (if Is_First (Title, Value, "bench", "jsbsim")
               then Bench_Plant else JSBSim_Plant);
         when Seed_Option =>
            Chosen.Seed := Seed_Number
              (Whole_Of (Title, Value, Number'Last));
         when Phase_Option =>
            Chosen.Phase := Phase_Ticks
              (Whole_Of (Title, Value, Number (Phase_Ticks'Last)));
         when Drift_Option =>
            Chosen.Drift := Drift_Number
              (Signed_Of (Title, Value, Integer (Drift_Number'Last)));
         when Lock_Option =>
            Chosen.Lock := True;
         when Line_Delay_Option =>
            Chosen.Line_Delay := Line_Delay_Of (Title, Value);
         when Schedule_Option =>
            Chosen.Schedule :=
              (if Is_First (Title, Value, "report", "fast")
               then Report else Fast);
         when Processors_Option =>
            Chosen.Processors := Processors_Of (Title, Value);
         when Laws_Option =>
            Chosen.Laws := Is_First (Title, Value, "on", "off");
         when Orbit_After_Option =>
            Loss_Times.Read_Orbit (Value, Chosen.Loss);
         when Terminate_After_Option =>
            Loss_Times.Read_Finish (Value, Chosen.Loss);
         when Recorder_Option =>
            Chosen.Recorder := Time_Of (Title, Value, Longest_Recording);
         when Format_Option =>
            Chosen.Format :=
              URV.Handshakes.Format_Number (Number_Of (Title, Value));
         when Packets_Option =>
            Chosen.Packets := Version_Of (Title, Value);
         when Publish_Option =>
            Add_Place (Chosen, To_Unbounded_String (Value));
         when Pace_Option =>
            Chosen.Pace :=
              (if Is_First (Title, Value, "max", "realtime")
               then Max else Realtime);
         when Quiet_Option =>
            Chosen.Quiet := True;
         when Link_Option | Sticks_Option .. Orders_Option | Key_Option
            | Console_Option | Output_Option =>
            null;
      end case;
   end Choose;

   procedure Add_Place (Chosen : in out Choices; Place : Unbounded_String) is
   begin
      for Free of Chosen.Publish loop
         if Free = Null_Unbounded_String then
            Free := Place;
            return;
         end if;
      end loop;
      Refuse
        (Name (Publish_Option) & " is given more than"
         & Integer'Image (Most_Places) & " times");
   end Add_Place;

   procedure Check (Caller : Program; Chosen : Choices) is

      Has_Aircraft : constant Boolean := Chosen.Plant = JSBSim_Plant;

      function Given (Which : Option) return Boolean is
        (Is_Given (Chosen, Which));

      procedure Refuse_Both (One : Option; Other : String) with No_Return;

      procedure Refuse_Both (One : Option; Other : String) is
      begin
         Refuse (Name (One) & " and " & Other & " do not go together");
      end Refuse_Both;

      Aircraft : constant String := Name (Plant_Option) & " jsbsim";

   begin
      if Has (Caller, Link_Option) and then not Given (Link_Option) then
         Refuse (Name (Link_Option) & " is missing; ""--help"" explains it");
      end if;
      Key_Files.Check (Chosen.Format, Given (Key_Option));
      Loss_Times.Check
        (Chosen.Loss,
         Given (Orbit_After_Option) or else Given (Terminate_After_Option),
         Chosen.Laws);
      if Given (Sticks_Option) and then Given (Console_Option) then
         Refuse_Both (Sticks_Option, Name (Console_Option));
      elsif Given (Sticks_Option) and then Given (Pilot_Option) then
         Refuse_Both (Pilot_Option, Name (Sticks_Option));
      elsif Given (Sensors_Option) and then Has_Aircraft then
         Refuse_Both (Sensors_Option, Aircraft);
      elsif Caller = URV_Sim and then Given (Pilot_Option) then
         if not Pilot.Exists (Value (Chosen, Pilot_Option)) then
            Refuse_Value
              (Name (Pilot_Option), Value (Chosen, Pilot_Option),
               "not a flight the pilot knows; there are " & Pilot.Names);
         elsif not Has_Aircraft then
            Refuse
              (Name (Pilot_Option) & " needs an aircraft to fly: add "
               & Aircraft);
         end if;
      end if;
   end Check;

   function Parsed (Caller : Program; First : Positive) return Choices is
      Chosen : Choices;
      Given  : Option_Set := (others => False);
      Index  : Positive   := First;

      --  The value that follows an option in an argument of its own.
      function Next_Argument return String is
        (if Index < Argument_Count then Argument (Index + 1) else "");

   begin
      while Index <= Argument_Count loop
         declare
            Text  : constant String := Argument (Index);
            Equal : Natural := Text'First;
            Which : Option;
         begin
            if Text in "--help" | "-h" | "help" then
               Chosen.Wants_Help := True;
               return Chosen;
            elsif Text = "--version" and then Caller /= URV_Sim then
               Chosen.Wants_Version := True;
               return Chosen;
            end if;

            --  Only an option is split, a stray argument is not.
            while Equal <= Text'Last
              and then (Text (Equal) /= '='
                        or else Text (Text'First) /= '-')
            loop
               Equal := Equal + 1;
            end loop;
            Which := Option_Of (Caller, Text (Text'First .. Equal - 1));

            if Given (Which) and then Which /= Publish_Option then
               Refuse (Name (Which) & " is given twice");
            end if;
            Given (Which) := True;

            if Value_Name (Which) = "" then
               if Equal <= Text'Last then
                  Refuse (Name (Which) & " takes no value");
               end if;
               Choose (Chosen, Which, "");
            elsif Equal < Text'Last then
               Choose (Chosen, Which, Text (Equal + 1 .. Text'Last));
            elsif Equal = Text'Last
              or else Next_Argument = ""
              or else (Next_Argument'Length >= 2
                       and then Next_Argument (1 .. 2) = "--")
            then
               Refuse (Name (Which) & " needs a value");
            else
               Choose (Chosen, Which, Next_Argument);
               Index := Index + 1;
            end if;
         end;
         Index := Index + 1;
      end loop;

      if not Given (Laws_Option) then
         Chosen.Laws := Chosen.Plant = JSBSim_Plant;
      end if;
      Check (Caller, Chosen);
      return Chosen;
   end Parsed;

end Host.Options;
