--  SPDX-License-Identifier: Apache-2.0

with Ada.Command_Line; use Ada.Command_Line;

with Host.Complaints;   use Host.Complaints;
with Host.Key_Files;
with Host.Pilot;
with Host.Schedules;
with Host.Text_Numbers; use Host.Text_Numbers;
with URVOS.Frames;      use URVOS.Frames;

package body Partitions.Options is

   use type Number;

   type Option is
     (Link_Option, Seconds_Option, Phase_Option, Lock_Option,
      Schedule_Option, Processors_Option,
      Format_Option, Key_Option, Script_Option, Console_Option,
      Pilot_Option, Packets_Option, Publish_Option, Plant_Option, Laws_Option,
      Record_Option, Summary_Option, Events_Option, Quiet_Option);

   --  Some have one node only.
   function Exists (This : Node; Which : Option) return Boolean is
     (case Which is
         when Console_Option .. Publish_Option => This = Ground,
         when Plant_Option | Laws_Option       => This = Aircraft,
         when others                           => True);

   type Option_Set is array (Option) of Boolean;

   Longest_Run : constant := 10_000_000;

   function Name (This : Node; Which : Option) return String is
     (case Which is
         when Link_Option       => "--link",
         when Seconds_Option    => "--seconds",
         when Phase_Option      => "--phase",
         when Lock_Option       => "--lock",
         when Schedule_Option   => "--schedule",
         when Processors_Option => "--processors",
         when Format_Option     => "--format",
         when Key_Option        => "--key",
         when Script_Option     => (if This = Ground then "--sticks"
                                    else "--sensors"),
         when Console_Option    => "--console",
         when Pilot_Option      => "--pilot",
         when Packets_Option    => "--packets",
         when Publish_Option    => "--publish",
         when Plant_Option      => "--plant",
         when Laws_Option       => "--laws",
         when Record_Option     => "--record",
         when Summary_Option    => "--summary",
         when Events_Option     => "--events",
         when Quiet_Option      => "--quiet");

   function Name (File : Output_File) return String is
     (case File is
         when Record_File  => Name (Ground, Record_Option),
         when Summary_File => Name (Ground, Summary_Option),
         when Events_File  => Name (Ground, Events_Option));

   procedure Choose
     (Chosen : in out Choices;
      Which  : Option;
      Value  : String);

   --  Another place to publish at.
   procedure Add_Place (Chosen : in out Choices; Given : Unbounded_String);

   --  Refuses options that do not go together.
   procedure Check (This : Node; Given : Option_Set; Chosen : Choices);

   --  An option and, if it is in the same argument, its value.
   procedure Split
     (This  : Node;
      Text  : String;
      Which : out Option;
      Equal : out Positive);

   procedure Choose
     (Chosen : in out Choices;
      Which  : Option;
      Value  : String)
   is
      Given    : constant Unbounded_String := To_Unbounded_String (Value);
      Amount   : Number;
      Is_Valid : Boolean;
   begin
      case Which is
         when Seconds_Option =>
            Read_Decimal (Value, 6, Amount, Is_Valid);
            if not Is_Valid
              or else Amount not in 1 .. Longest_Run * Microseconds_Per_Second
            then
               Refuse
                 ("--seconds: " & Quoted (Value)
                  & " is not a number of seconds above 0 and up to"
                  & Longest_Run'Image & " with at most six decimals");
            end if;
            Chosen.Frames := URVOS.Count
              ((Amount + Frame_Length - 1) / Frame_Length);

         when Phase_Option =>
            Read_Whole (Value, Amount, Is_Valid);
            if not Is_Valid or else Amount > Number (Phase_Ticks'Last) then
               Refuse
                 ("--phase: " & Quoted (Value)
                  & " is not a whole number from 0 to"
                  & Phase_Ticks'Image (Phase_Ticks'Last));
            end if;
            Chosen.In_Phase := True;
            Chosen.Phase := Phase_Ticks (Amount);

         when Processors_Option =>
            Read_Whole (Value, Amount, Is_Valid);
            if not Is_Valid
              or else Amount not in 1 .. Number (Processor_Number'Last)
            then
               Refuse
                 ("--processors: " & Quoted (Value) & " is neither 1 nor 2");
            end if;
            Chosen.Processors := Processor_Number (Amount);

         when Plant_Option =>
            if Value = "bench" then
               Chosen.Plant := Bench_Plant;
            elsif Value = "jsbsim" then
               Chosen.Plant := JSBSim_Plant;
            else
               Refuse
                 ("--plant: " & Quoted (Value)
                  & " is neither ""bench"" nor ""jsbsim""");
            end if;

         when Packets_Option =>
            if Value not in "1" | "2" then
               Refuse
                 ("--packets: " & Quoted (Value) & " is neither 1 nor 2");
            end if;
            Chosen.Packets := (if Value = "1" then 1 else 2);

         when Laws_Option =>
            if Value not in "on" | "off" then
               Refuse
                 ("--laws: " & Quoted (Value)
                  & " is neither ""on"" nor ""off""");
            end if;
            Chosen.Laws := Value = "on";

         when Lock_Option =>
            Chosen.Lock := True;

         when Schedule_Option =>
            Chosen.Schedule := Schedules.Schedule_Of (Value);

         when Format_Option =>
            Chosen.Format := Key_Files.Format_Of (Value);

         when Key_Option     => Chosen.Key := Given;
         when Publish_Option => Add_Place (Chosen, Given);
         when Link_Option    => Chosen.Link := Given;
         when Script_Option  => Chosen.Script := Given;
         when Console_Option => Chosen.Console := Given;
         when Pilot_Option   => Chosen.Pilot := Given;
         when Record_Option  => Chosen.Outputs (Record_File) := Given;
         when Summary_Option => Chosen.Outputs (Summary_File) := Given;
         when Events_Option  => Chosen.Outputs (Events_File) := Given;
         when Quiet_Option   => Chosen.Quiet := True;
      end case;
   end Choose;

   procedure Add_Place (Chosen : in out Choices; Given : Unbounded_String) is
   begin
      for Place of Chosen.Publish loop
         if Place = Null_Unbounded_String then
            Place := Given;
            return;
         end if;
      end loop;
      Refuse
        ("--publish is given more than" & Integer'Image (Most_Places)
         & " times");
   end Add_Place;

   procedure Check (This : Node; Given : Option_Set; Chosen : Choices) is

      procedure Refuse_Both (Another : Option; Value : String := "")
        with No_Return;

      procedure Refuse_Both (Another : Option; Value : String := "") is
      begin
         Refuse
           (Name (This, Script_Option) & " and " & Name (This, Another)
            & Value & " do not go together");
      end Refuse_Both;

   begin
      if not Given (Link_Option) then
         Refuse ("--link is missing; ""--help"" explains it");
      end if;
      Key_Files.Check (Chosen.Format, Given (Key_Option));
      if not Given (Script_Option) then
         return;
      elsif Given (Console_Option) then
         Refuse_Both (Console_Option);
      elsif Given (Pilot_Option) then
         Refuse_Both (Pilot_Option);
      elsif Chosen.Plant = JSBSim_Plant then
         Refuse_Both (Plant_Option, " jsbsim");
      end if;
   end Check;

   procedure Split
     (This  : Node;
      Text  : String;
      Which : out Option;
      Equal : out Positive) is
   begin
      Equal := Text'First;
      while Equal <= Text'Last and then Text (Equal) /= '=' loop
         Equal := Equal + 1;
      end loop;
      for Candidate in Option loop
         if Exists (This, Candidate)
           and then Name (This, Candidate) = Text (Text'First .. Equal - 1)
         then
            Which := Candidate;
            return;
         end if;
      end loop;

      if Text'Length > 0 and then Text (Text'First) = '-' then
         Refuse ("unknown option " & Quoted (Text (Text'First .. Equal - 1)));
      else
         Refuse ("unexpected argument " & Quoted (Text));
      end if;
   end Split;

   function Parsed (This : Node) return Choices is
      Chosen : Choices;
      Given  : Option_Set := (others => False);
      Index  : Positive   := 1;
      Which  : Option;
      Equal  : Positive;
   begin
      while Index <= Argument_Count loop
         declare
            Text : constant String := Argument (Index);
         begin
            if Text in "help" | "--help" | "-h" then
               Chosen.Help := True;
               return Chosen;
            end if;

            Split (This, Text, Which, Equal);
            if Given (Which) and then Which /= Publish_Option then
               Refuse (Name (This, Which) & " is given twice");
            end if;
            Given (Which) := True;

            if Which in Lock_Option | Quiet_Option then
               if Equal <= Text'Last then
                  Refuse (Name (This, Which) & " takes no value");
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
               Refuse (Name (This, Which) & " needs a value");
            else
               Index := Index + 1;
               Choose (Chosen, Which, Argument (Index));
            end if;
         end;
         Index := Index + 1;
      end loop;

      if not Given (Laws_Option) then
         Chosen.Laws := Chosen.Plant = JSBSim_Plant;
      end if;
      Check (This, Given, Chosen);
      return Chosen;
   end Parsed;

   procedure Print_Usage
     (To : in out Host.Text_Output.Writer; This : Node)
   is
      Program : constant String :=
        (if This = Ground then "urv_gsc" else "urv_mcs");

      procedure Put_Line (Line : String);
      procedure New_Line;

      procedure Put_Line (Line : String) is
      begin
         Host.Text_Output.Put_Line (To, Line);
      end Put_Line;

      procedure New_Line is
      begin
         Host.Text_Output.New_Line (To);
      end New_Line;
   begin
      Put_Line
        ("usage: " & Program & " --link LINK [options]");
      New_Line;
      Put_Line
        ("Runs the " & (if This = Ground then "ground station core"
                        else "aircraft's control system")
         & " in real time, until SIGINT or SIGTERM.");
      Put_Line
        ("SIGUSR1 raises a processor exception, SIGUSR2 presses the reset"
         & " switch.");
      New_Line;
      Put_Line
        ("  --link udp:HOST:PORT:PEER_HOST:PEER_PORT");
      Put_Line
        ("  --link serial:DEVICE   the serial line to the other node");
      Put_Line
        ("  --seconds S            ends the run; 0.5 is half a second");
      Put_Line
        ("  --phase TICKS          switches the node on so many times"
         & Integer'Image
             (Microseconds_Per_Tick / Microseconds_Per_Millisecond)
         & " ms after a whole");
      Put_Line
        ("                        " & Integer'Image (Frame_Milliseconds)
         & " ms of the machine's clock; else at once");
      Put_Line
        ("  --lock                 the aircraft's frames come in step with the"
         & " ground's");
      Put_Line
        ("  --schedule NAME        of the tasks: " & Schedules.Names
         & "; else report");
      Put_Line
        ("  --processors N         so many of the node, 1 or 2; else 1");
      Put_Line
        ("  --format N             of the messages, 1 or 2, which is sealed;"
         & " else 1");
      Put_Line
        ("  --key FILE             the keys of format 2");
      if This = Ground then
         Put_Line
           ("  --sticks FILE          the pilot's console input");
         Put_Line
           ("  --console udp:HOST:PORT");
         Put_Line
           ("                         the same from a console's packets; HOST"
            & " is this");
         Put_Line
           ("                         machine's loopback");
         Put_Line
           ("  --pilot NAME           the simulated pilot flies while no"
            & " console does:");
         Put_Line
           ("                         " & Host.Pilot.Names (By_Eye => False));
         Put_Line
           ("  --publish udp:HOST:PORT");
         Put_Line
           ("                         sends there what CORE has each frame;"
            & " up to" & Integer'Image (Most_Places) & " times");
         Put_Line
           ("  --packets N            of that version, 1 or 2, which has the"
            & " whole log; else 1");
      else
         Put_Line
           ("  --sensors FILE         sensor words; else surfaces follow"
            & " the servos");
         Put_Line
           ("  --plant PLANT          bench, or jsbsim: an aircraft in"
            & " flight; else bench");
         Put_Line
           ("  --laws LAWS            the control laws, on or off; else on"
            & " with jsbsim");
      end if;
      Put_Line
        ("  --record FILE          a row for each major frame");
      Put_Line
        ("  --summary FILE         result as JSON");
      Put_Line
        ("  --events FILE          event log as JSON lines");
      Put_Line
        ("  --quiet                no summary, and not a word about the other"
         & " node");
      New_Line;
      Put_Line
        ("Exit status: 0 run; 1 an output cannot be written, or an internal"
         & " fault"
         & (if This = Ground then ";" else ", or the"));
      Put_Line
        ((if This = Ground then "" else "plant has died; ")
         & "2 a bad command line, input file or link.");
   end Print_Usage;

end Partitions.Options;
