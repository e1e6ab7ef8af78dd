--  SPDX-License-Identifier: Apache-2.0

--  The options of all programs, and the user's choices: --option VALUE or
--  --option=VALUE, in any order, each once except --publish. Any error raises
--  Bad_Input (SIM-1, RTP-2). --help, and a partition's --version, end the
--  command line. --phase is the phase between the two nodes' clocks (D-12),
--  --schedule that of the tasks (FRM-5).
--
--  A new option needs a literal here with its program, and in the body the
--  name of its value and its effect; Host.Option_Help explains it.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Host.Loss_Times;
with Host.Option_Values; use Host.Option_Values;
with Telemetry;
with URV.Handshakes;
with URV.Recorder_Sizes;
with URVOS.Task_Trees;

package Host.Options is

   type Program is (URV_Sim, URV_GSC, URV_MCS);

   --  In the order of the help. Seconds_Option is written --seconds,
   --  Orbit_After_Option --orbit-after.
   type Option is
     (Link_Option, Seconds_Option, Plant_Option, Sticks_Option, Pilot_Option,
      Sensors_Option, Faults_Option, Conditions_Option, Orders_Option,
      Seed_Option, Phase_Option, Drift_Option, Lock_Option, Line_Delay_Option,
      Schedule_Option, Processors_Option, Laws_Option, Orbit_After_Option,
      Terminate_After_Option, Format_Option, Key_Option,
      Recorder_Option, Console_Option, Packets_Option, Publish_Option,
      Record_Option, Recording_Option, Fetched_Option, Summary_Option,
      Wire_Option, Events_Option, Pace_Option, Quiet_Option);

   subtype Output_Option is Option range Record_Option .. Events_Option;

   function Has (Caller : Program; Which : Option) return Boolean is
     (case Which is
         when Link_Option                               => Caller /= URV_Sim,
         when Sticks_Option | Pilot_Option
            | Orders_Option                             => Caller /= URV_MCS,
         when Plant_Option | Sensors_Option
            | Laws_Option .. Terminate_After_Option
            | Recorder_Option | Recording_Option     => Caller /= URV_GSC,
         when Console_Option .. Publish_Option          => Caller = URV_GSC,
         when Faults_Option | Conditions_Option
            | Seed_Option | Drift_Option | Wire_Option
            | Fetched_Option | Pace_Option              => Caller = URV_Sim,
         when others                                    => True);

   --  As it is written, with its dashes.
   function Name (Which : Option) return String;

   --  The name of its value; "" for an option without a value.
   function Value_Name (Which : Option) return String;

   --  The plant that the boards are connected to.
   type Plant_Kind is (Bench_Plant, JSBSim_Plant);

   --  As fast as possible, or at the speed of real time.
   type Pace_Kind is (Max, Realtime);

   --  The destinations of the ground's frames; empty after the last one.
   Most_Places : constant := 8;
   type Place_List is array (1 .. Most_Places) of Unbounded_String;

   --  The values as they were given; empty if absent.
   type Value_List is array (Option) of Unbounded_String;

   Longest_Time : constant Microseconds :=
     10_000_000 * Microseconds_Per_Second;

   Longest_Recording : constant Microseconds :=
     URV.Recorder_Sizes.Most_Rows * Frame_Length;

   type Choices is record
      Wants_Help    : Boolean := False;
      Wants_Version : Boolean := False;

      Values     : Value_List;
      Publish    : Place_List;

      --  0 when --seconds was not given.
      Length     : Microseconds range 0 .. Longest_Time := 0;

      Plant      : Plant_Kind := Bench_Plant;
      Seed       : Seed_Number := 1;
      Phase      : Phase_Ticks := Usual_Phase;
      Drift      : Drift_Number := 0;
      Schedule   : Schedule_Name := URVOS.Task_Trees.Report;

      --  The processors of each node.
      Processors : URVOS.Task_Trees.Processor_Number := 1;

      --  The aircraft's control laws (EXT-3): by default on with an aircraft,
      --  off with the bench.
      Laws       : Boolean := False;

      --  The times of the reactions to a lost link, with the laws (EXT-5).
      Loss       : Loss_Times.Pair;

      --  The time that the aircraft's flight recorder holds (FTI-9).
      Recorder   : Microseconds range 0 .. Longest_Recording :=
        Longest_Recording;

      --  The message format; format 2 has keys.
      Format     : URV.Handshakes.Format_Number := 1;

      --  The version of the published packets.
      Packets    : One_To_Three := 1;

      Pace       : Pace_Kind := Max;

      --  The aircraft's frames follow the ground's.
      Lock       : Boolean := False;

      --  The delay of the line between the boards, one way; the boards are set
      --  to the same value (LNK-11).
      Line_Delay : Telemetry.Line_Delay := 0;

      Quiet      : Boolean := False;
   end record;

   function Is_Given (Chosen : Choices; Which : Option) return Boolean is
     (Chosen.Values (Which) /= Null_Unbounded_String)
     with Pre => Value_Name (Which) /= "";

   function Value (Chosen : Choices; Which : Option) return String is
     (To_String (Chosen.Values (Which)));

   --  The options in the command line, from that argument on.
   function Parsed (Caller : Program; First : Positive) return Choices;

end Host.Options;
