--  SPDX-License-Identifier: Apache-2.0

with Ada.Command_Line; use Ada.Command_Line;

with Host.Complaints;   use Host.Complaints;
with Host.Key_Files;
with Host.Pilot;
with Host.Schedules;
with Host.Text_Numbers; use Host.Text_Numbers;
with Sim.Options.Usage;

package body Sim.Options is

   use type Number;

   type Option is
     (Seconds_Option, Plant_Option, Sticks_Option, Pilot_Option,
      Sensors_Option, Faults_Option, Conditions_Option, Orders_Option,
      Seed_Option, Phase_Option, Drift_Option, Lock_Option, Schedule_Option,
      Processors_Option, Laws_Option, Format_Option, Key_Option,
      Record_Option, Summary_Option, Wire_Option, Events_Option,
      Pace_Option, Quiet_Option);

   Commands_With_Help : constant String := "fly, items, numbers";
   All_Titles : constant String := Commands_With_Help & ", help, --version";

   type Option_Set is array (Option) of Boolean;

   function Name (Which : Option) return String is
     (case Which is
         when Seconds_Option    => "--seconds",
         when Plant_Option      => "--plant",
         when Sticks_Option     => "--sticks",
         when Pilot_Option      => "--pilot",
         when Sensors_Option    => "--sensors",
         when Faults_Option     => "--faults",
         when Conditions_Option => "--conditions",
         when Orders_Option     => "--orders",
         when Seed_Option       => "--seed",
         when Phase_Option      => "--phase",
         when Drift_Option      => "--drift",
         when Lock_Option       => "--lock",
         when Schedule_Option   => "--schedule",
         when Processors_Option => "--processors",
         when Laws_Option       => "--laws",
         when Format_Option     => "--format",
         when Key_Option        => "--key",
         when Record_Option     => "--record",
         when Summary_Option    => "--summary",
         when Wire_Option       => "--wire",
         when Events_Option     => "--events",
         when Pace_Option       => "--pace",
         when Quiet_Option      => "--quiet");

   function Name (File : Input_File) return String is
     (case File is
         when Stick_File     => Name (Sticks_Option),
         when Sensor_File    => Name (Sensors_Option),
         when Fault_File     => Name (Faults_Option),
         when Condition_File => Name (Conditions_Option),
         when Order_File     => Name (Orders_Option));

   function Name (File : Output_File) return String is
     (case File is
         when Record_File  => Name (Record_Option),
         when Summary_File => Name (Summary_Option),
         when Wire_File    => Name (Wire_Option),
         when Event_File   => Name (Events_Option));

   --  Refuses an option's value.
   procedure Refuse_Value
     (Which : Option;
      Value : String;
      What  : String) with No_Return;

   --  The options from that one on, in a list.
   function Names_From (Which : Option) return String;

   --  Finds the option of that name, or refuses it.
   function Option_Of (Title : String) return Option;

   --  Takes an option's value over into the choices.
   procedure Choose
     (Chosen : in out Choices;
      Which  : Option;
      Value  : String);

   --  What --drift says.
   procedure Read_Drift (Value : String; Drift : out Drift_Number);

   --  Takes the options that follow the command.
   procedure Read_Options
     (Chosen : in out Choices;
      Given  : out Option_Set);

   --  Takes what follows help.
   procedure Read_Topic (Chosen : in out Choices);

   --  Refuses options that do not go together, and a pilot without an
   --  aircraft.
   procedure Check_Conflicts (Chosen : Choices; Given : Option_Set);

   procedure Refuse_Value
     (Which : Option;
      Value : String;
      What  : String) is
   begin
      Refuse (Name (Which) & ": " & Quoted (Value) & " " & What);
   end Refuse_Value;

   function Names_From (Which : Option) return String is
     (Name (Which)
      & (if Which = Option'Last then ""
         else ", " & Names_From (Option'Succ (Which))));

   function Option_Of (Title : String) return Option is
   begin
      for Which in Option loop
         if Name (Which) = Title then
            return Which;
         end if;
      end loop;
      if Title'Length > 1 and then Title (Title'First) = '-' then
         Refuse
           ("unknown option " & Quoted (Title) & "; there are "
            & Names_From (Option'First));
      else
         Refuse ("unexpected argument " & Quoted (Title));
      end if;
   end Option_Of;

   procedure Read_Drift (Value : String; Drift : out Drift_Number) is
      Is_Minus : constant Boolean :=
        Value'Length > 1 and then Value (Value'First) = '-';
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      Read_Whole
        (Value (Value'First + Boolean'Pos (Is_Minus) .. Value'Last), Amount,
         Is_Valid);
      if not Is_Valid or else Amount > Number (Drift_Number'Last) then
         Refuse_Value
           (Drift_Option, Value,
            "is not a whole number from"
            & " " & Drift_Number'Image (Drift_Number'First) & " to"
            & Drift_Number'Image (Drift_Number'Last));
      end if;
      Drift := (if Is_Minus then -Drift_Number (Amount)
                else Drift_Number (Amount));
   end Read_Drift;

   procedure Choose
     (Chosen : in out Choices;
      Which  : Option;
      Value  : String)
   is
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      case Which is
         when Seconds_Option =>
            Read_Decimal (Value, 6, Amount, Is_Valid);
            if not Is_Valid
              or else Amount not in 1 .. Number (Longest_Flight)
            then
               Refuse_Value
                 (Which, Value,
                  "is not a number of seconds above 0 and up to"
                  & Microseconds'Image
                      (Longest_Flight / Microseconds_Per_Second)
                  & " with at most six decimals");
            end if;
            Chosen.Length := Microseconds (Amount);

         when Plant_Option =>
            if Value = "bench" then
               Chosen.Plant := Bench_Plant;
            elsif Value = "jsbsim" then
               Chosen.Plant := JSBSim_Plant;
            else
               Refuse_Value
                 (Which, Value, "is neither ""bench"" nor ""jsbsim""");
            end if;

         when Pace_Option =>
            if Value = "max" then
               Chosen.Pace := Max;
            elsif Value = "realtime" then
               Chosen.Pace := Realtime;
            else
               Refuse_Value
                 (Which, Value, "is neither ""max"" nor ""realtime""");
            end if;

         when Seed_Option =>
            Read_Whole (Value, Amount, Is_Valid);
            if not Is_Valid then
               Refuse_Value
                 (Which, Value,
                  "is not a whole number from 0 to"
                  & Seed_Number'Image (Seed_Number'Last));
            end if;
            Chosen.Seed := Seed_Number (Amount);

         when Phase_Option =>
            Read_Whole (Value, Amount, Is_Valid);
            if not Is_Valid or else Amount > Number (Phase_Ticks'Last) then
               Refuse_Value
                 (Which, Value,
                  "is not a whole number from 0 to"
                  & Phase_Ticks'Image (Phase_Ticks'Last));
            end if;
            Chosen.Phase := Phase_Ticks (Amount);

         when Processors_Option =>
            Read_Whole (Value, Amount, Is_Valid);
            if not Is_Valid
              or else Amount not in 1 .. Number (Processor_Count'Last)
            then
               Refuse_Value (Which, Value, "is neither 1 nor 2");
            end if;
            Chosen.Processors := Processor_Count (Amount);

         when Laws_Option =>
            if Value = "on" then
               Chosen.Laws := On;
            elsif Value = "off" then
               Chosen.Laws := Off;
            else
               Refuse_Value (Which, Value, "is neither ""on"" nor ""off""");
            end if;

         when Drift_Option =>
            Read_Drift (Value, Chosen.Drift);
         when Lock_Option =>
            Chosen.Lock := True;
         when Schedule_Option =>
            Chosen.Schedule := Schedules.Schedule_Of (Value);
         when Format_Option  =>
            Chosen.Format := Key_Files.Format_Of (Value);
         when Key_Option     =>
            Chosen.Key := To_Unbounded_String (Value);
         when Pilot_Option   =>
            Chosen.Pilot := To_Unbounded_String (Value);
         when Sticks_Option  =>
            Chosen.Inputs (Stick_File) := To_Unbounded_String (Value);
         when Sensors_Option =>
            Chosen.Inputs (Sensor_File) := To_Unbounded_String (Value);
         when Faults_Option  =>
            Chosen.Inputs (Fault_File) := To_Unbounded_String (Value);
         when Conditions_Option =>
            Chosen.Inputs (Condition_File) := To_Unbounded_String (Value);
         when Orders_Option  =>
            Chosen.Inputs (Order_File) := To_Unbounded_String (Value);
         when Record_Option  =>
            Chosen.Outputs (Record_File) := To_Unbounded_String (Value);
         when Summary_Option =>
            Chosen.Outputs (Summary_File) := To_Unbounded_String (Value);
         when Wire_Option    =>
            Chosen.Outputs (Wire_File) := To_Unbounded_String (Value);
         when Events_Option  =>
            Chosen.Outputs (Event_File) := To_Unbounded_String (Value);

         when Quiet_Option =>
            Chosen.Quiet := True;
      end case;
   end Choose;

   procedure Read_Options
     (Chosen : in out Choices;
      Given  : out Option_Set)
   is
      --  The first argument is the command.
      Index : Positive := 2;
   begin
      Given := (others => False);
      while Index <= Argument_Count loop
         declare
            Text  : constant String := Argument (Index);
            Equal : Natural := Text'First;
            Which : Option;
         begin
            if Text = "--help" or else Text = "-h" then
               Chosen.Order := Help;
               Chosen.Topic := Of_Fly;
               return;
            end if;

            --  Only an option is split, a stray argument is not.
            while Equal <= Text'Last
              and then (Text (Equal) /= '='
                        or else Text (Text'First) /= '-')
            loop
               Equal := Equal + 1;
            end loop;
            Which := Option_Of (Text (Text'First .. Equal - 1));

            if Given (Which) then
               Refuse (Name (Which) & " is given twice");
            end if;
            Given (Which) := True;

            if Which in Lock_Option | Quiet_Option then
               if Equal <= Text'Last then
                  Refuse (Name (Which) & " takes no value");
               end if;
               Choose (Chosen, Which, "");
            elsif Equal < Text'Last then
               Choose (Chosen, Which, Text (Equal + 1 .. Text'Last));
            elsif Equal = Text'Last
              or else Index = Argument_Count
              or else Argument (Index + 1) = ""
              or else (Argument (Index + 1)'Length >= 2
                       and then Argument (Index + 1) (1 .. 2) = "--")
            then
               Refuse (Name (Which) & " needs a value");
            else
               Index := Index + 1;
               Choose (Chosen, Which, Argument (Index));
            end if;
         end;
         Index := Index + 1;
      end loop;
   end Read_Options;

   procedure Check_Conflicts (Chosen : Choices; Given : Option_Set) is
   begin
      Key_Files.Check (Chosen.Format, Given (Key_Option));
      if Given (Pilot_Option) and then Given (Sticks_Option) then
         Refuse
           (Name (Pilot_Option) & " and " & Name (Sticks_Option)
            & " do not go together");
      elsif Given (Sensors_Option) and then Chosen.Plant = JSBSim_Plant then
         Refuse
           (Name (Sensors_Option) & " and " & Name (Plant_Option)
            & " jsbsim do not go together");
      elsif Given (Conditions_Option) and then Chosen.Plant /= JSBSim_Plant
      then
         Refuse
           (Name (Conditions_Option) & " are those of an aircraft: add "
            & Name (Plant_Option) & " jsbsim");
      elsif Given (Pilot_Option) then
         if not Pilot.Exists (To_String (Chosen.Pilot)) then
            Refuse_Value
              (Pilot_Option, To_String (Chosen.Pilot),
               "is not a flight the pilot knows; there are " & Pilot.Names);
         elsif Chosen.Plant /= JSBSim_Plant then
            Refuse
              (Name (Pilot_Option) & " needs an aircraft to fly: add "
               & Name (Plant_Option) & " jsbsim");
         end if;
      end if;
   end Check_Conflicts;

   procedure Read_Topic (Chosen : in out Choices) is
   begin
      if Argument (2) = "fly" then
         Chosen.Topic := Of_Fly;
      elsif Argument (2) = "items" then
         Chosen.Topic := Of_Items;
      elsif Argument (2) = "numbers" then
         Chosen.Topic := Of_Numbers;
      else
         Refuse
           ("unknown command " & Quoted (Argument (2)) & "; there are "
            & Commands_With_Help);
      end if;
   end Read_Topic;

   function Parsed return Choices is
      Chosen : Choices;
      Given  : Option_Set;
   begin
      if Argument_Count = 0 then
         Refuse ("no command; there are " & All_Titles);
      end if;

      declare
         Title : constant String := Argument (1);
      begin
         if Title = "help" or else Title = "--help" or else Title = "-h" then
            Chosen.Order := Help;
         elsif Title = "items" then
            Chosen.Order := Items;
         elsif Title = "numbers" then
            Chosen.Order := Numbers;
         elsif Title = "--version" then
            Chosen.Order := Version;
         elsif Title = "fly" then
            Chosen.Order := Fly;
         else
            Refuse
              ("unknown command " & Quoted (Title) & "; there are "
               & All_Titles);
         end if;
      end;

      if Chosen.Order /= Fly then
         if Chosen.Order = Help and then Argument_Count = 2 then
            Read_Topic (Chosen);
         elsif Argument_Count > 1 then
            Refuse
              ("unexpected argument "
               & Quoted
                   (Argument (if Chosen.Order = Help then 3 else 2)));
         end if;
         return Chosen;
      end if;

      Read_Options (Chosen, Given);
      if Chosen.Order = Fly then
         Check_Conflicts (Chosen, Given);
      end if;
      return Chosen;
   end Parsed;

   function Flight_Length
     (Chosen    : Choices;
      Otherwise : Microseconds) return Microseconds
   is
      Length : constant Microseconds :=
        (if Chosen.Length > 0 then Chosen.Length
         elsif Otherwise > 0 then Otherwise
         else Standard_Length);
   begin
      return (Length + Major_Frame - 1) / Major_Frame * Major_Frame;
   end Flight_Length;

   procedure Print_Usage
     (To    : in out Text_Output.Writer;
      Topic : Help_Topic) renames Usage.Print;

end Sim.Options;
