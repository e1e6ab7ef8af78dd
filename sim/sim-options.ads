--  SPDX-License-Identifier: Apache-2.0

--  The command line of urv_sim: what was asked for, and the text that
--  explains it. Whatever is wrong with it raises Bad_Input (SIM-1).
--  --phase is the phase between the two nodes' clocks (D-12).

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Host.Text_Output;
with Sim.Nodes;
with Sim.Noise;
with URVOS.Task_Trees;
with URV.Seals;

package Sim.Options is

   type Command is (Help, Items, Numbers, Version, Fly);

   --  What help is about.
   type Help_Topic is (All_Commands, Of_Fly, Of_Items, Of_Numbers);

   --  What is behind the boards.
   type Plant_Kind is (Bench_Plant, JSBSim_Plant);

   --  As fast as possible, or as fast as the clock on the wall.
   type Pace_Kind is (Max, Realtime);

   --  The aircraft's control laws: with a plant that they are for, or as the
   --  user says.
   type Law_Choice is (By_Plant, On, Off);

   subtype Processor_Count is Nodes.Processor_Count;

   subtype Seed_Number is Noise.Seed_Number;

   subtype Format_Number is URV.Seals.Format_Number;

   type Input_File is
     (Stick_File, Sensor_File, Fault_File, Condition_File, Order_File);
   type Output_File is (Record_File, Summary_File, Wire_File, Event_File);

   --  Names of files. An empty one was not given.
   type Input_Names is array (Input_File) of Unbounded_String;
   type Output_Names is array (Output_File) of Unbounded_String;

   Longest_Flight  : constant Microseconds :=
     10_000_000 * Microseconds_Per_Second;
   Standard_Length : constant Microseconds := 60 * Microseconds_Per_Second;

   type Choices is record
      Order   : Command := Help;
      Topic   : Help_Topic := All_Commands;
      Plant   : Plant_Kind := Bench_Plant;
      Inputs  : Input_Names;
      Outputs : Output_Names;
      Seed    : Seed_Number := 1;
      Phase   : Phase_Ticks := Usual_Phase;
      Pace    : Pace_Kind := Max;
      Quiet   : Boolean := False;

      --  By how many millionths the aircraft's ticks are longer, and whether
      --  its frames come in step with the ground's.
      Drift : Drift_Number := 0;
      Lock  : Boolean := False;

      --  Of both nodes.
      Schedule : Schedule_Name := URVOS.Task_Trees.Report;

      --  Of the aircraft's node.
      Processors : Processor_Count := 1;

      Laws : Law_Choice := By_Plant;
      --  Of the messages; the file of keys is empty in format 1.
      Format : Format_Number := 1;
      Key    : Unbounded_String;

      --  The flight the simulated pilot flies; empty for nobody.
      Pilot : Unbounded_String;

      --  0 when --seconds was not given.
      Length : Microseconds range 0 .. Longest_Flight := 0;
   end record;

   --  What the program was called with.
   function Parsed return Choices;

   function Has_Laws (Chosen : Choices) return Boolean is
     (case Chosen.Laws is
         when By_Plant => Chosen.Plant = JSBSim_Plant,
         when On       => True,
         when Off      => False);

   --  How long to fly, in whole frames: as --seconds says; else as long
   --  as the sticks or the pilot need, if that is not 0; else 60 s.
   function Flight_Length
     (Chosen    : Choices;
      Otherwise : Microseconds) return Microseconds
     with Post => Flight_Length'Result > 0
                  and then Flight_Length'Result mod Major_Frame = 0;

   --  How an option that names a file is written, for complaints.
   function Name (File : Input_File) return String;
   function Name (File : Output_File) return String;

   --  Prints how the program is used.
   procedure Print_Usage
     (To    : in out Text_Output.Writer;
      Topic : Help_Topic)
     with Pre => Text_Output.Is_Open (To);

end Sim.Options;
