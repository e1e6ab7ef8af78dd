--  SPDX-License-Identifier: Apache-2.0

with Devices.Memory_Bus; use Devices.Memory_Bus;
with URVOS.Start_Phases;
with URVOS.Start_Tests;
with URV.Start_Records;

package body URV.Start_Routines with SPARK_Mode is

   package Test is new URVOS.Start_Tests
     (Last_Long => Last_ROM_Long,
      Last_Word => Last_RAM_Word,
      Read_ROM  => Memories.Read_ROM,
      Read_RAM  => Memories.Read_RAM,
      Write_RAM => Memories.Write_RAM);

   package Records is new URV.Start_Records (CORE_Memory, Errors);

   procedure Set_Time (Now : Clock_Tick);

   procedure Clear_Telemetry;

   procedure Cold_Start;

   procedure Warm_Start;

   procedure Refuse;

   procedure Set_Time (Now : Clock_Tick) is
   begin
      Errors.Set_Time (Now);
      Sealing.Set_Time (Now);
   end Set_Time;

   procedure Clear_Telemetry is
   begin
      Telemetry_Board.Clear_Transmit_Half;
      Telemetry_Board.Discard_Received;
   end Clear_Telemetry;

   procedure Cold_Start is
   begin
      CORE_Memory.Clear;
      Clear_Telemetry;
      Reset_Variables;
   end Cold_Start;

   procedure Warm_Start is
   begin
      CORE_Memory.Mark_Old;
      Clear_Telemetry;
      Restart_Variables;
   end Warm_Start;

   --  Discards earlier commands unsent (SAF-4). CORE's status is on the ground
   --  (TST-4).
   procedure Refuse is
   begin
      Telemetry_Board.Clear_Transmit_Half;
      Report_Refused_Start;
   end Refuse;

   package Phases is new URVOS.Start_Phases
     (Test              => Test.Run,
      Record_Start      => Records.Record_Start,
      Refuse            => Refuse,
      Cold_Start        => Cold_Start,
      Warm_Reset        => Warm_Start,
      Processor_Restart => Warm_Start,
      Set_Time          => Set_Time);

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean)
     renames Phases.Run;

end URV.Start_Routines;
