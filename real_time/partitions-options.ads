--  SPDX-License-Identifier: Apache-2.0

--  The command line of a partition (RTP-2). Whatever is wrong with it
--  raises Host.Bad_Input.

with Ada.Strings.Unbounded; use Ada.Strings.Unbounded;

with Host;  use Host;
with Host.Text_Output;
with Partitions.Frame_Packets;
with URV.Seals;
with URVOS;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package Partitions.Options is

   --  What a partition writes.
   type Output_File is (Record_File, Summary_File, Events_File);
   type Output_Names is array (Output_File) of Unbounded_String;

   --  Where the ground's frames are sent; empty after the last one.
   Most_Places : constant := 8;
   type Place_List is array (1 .. Most_Places) of Unbounded_String;

   type Plant_Kind is (Bench_Plant, JSBSim_Plant);

   --  Names are empty, and Frames is 0, when they were not given.
   type Choices is record
      Help    : Boolean := False;
      Link    : Unbounded_String;
      Script  : Unbounded_String;
      Publish : Place_List;
      Packets : Frame_Packets.Version_Number := 1;
      Console : Unbounded_String;
      Pilot   : Unbounded_String;
      Plant   : Plant_Kind := Bench_Plant;

      --  The aircraft's control laws (EXT-3).
      Laws    : Boolean := False;

      Outputs : Output_Names;
      Quiet   : Boolean := False;
      Frames  : URVOS.Count := 0;

      --  Where in the major frames of the machine's clock the node is
      --  switched on; at once when not In_Phase.
      In_Phase : Boolean := False;
      Phase    : Phase_Ticks := 0;

      --  The aircraft's frames come in step with the ground's.
      Lock       : Boolean := False;

      Schedule   : Host.Schedule_Name := Report;
      Processors : Processor_Number := 1;

      --  Of the messages; the file of keys is empty in format 1.
      Format : URV.Seals.Format_Number := 1;
      Key    : Unbounded_String;
   end record;

   function Parsed (This : Node) return Choices;

   --  How an output is asked for, for complaints.
   function Name (File : Output_File) return String;

   procedure Print_Usage
     (To : in out Host.Text_Output.Writer; This : Node);

end Partitions.Options;
