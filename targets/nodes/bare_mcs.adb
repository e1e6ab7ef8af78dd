--  SPDX-License-Identifier: Apache-2.0

with Bare_Memories;
pragma Unreferenced (Bare_Memories);
with MCS.Bare_Metal;
with URV.Buffers; use URV.Buffers;
with URV.CORE_Memory;
with URV.Laws;
with URV.PWM_Layout;
with Last_Chance;
pragma Unreferenced (Last_Chance);
with Machine_Needs;
pragma Unreferenced (Machine_Needs);
with Machine_Texts; use Machine_Texts;
with Node_Programs;
with Targets;
with Telemetry;
with URVOS;         use URVOS;
with URVOS.Starts;  use URVOS.Starts;

package body Bare_MCS is

   package Node renames MCS.Bare_Metal;

   procedure Begin_Start (Condition : Start_Condition);

   procedure Tick_Boards;

   procedure Write_Outputs;
   procedure Begin_Start (Condition : Start_Condition) is
   begin
      Node.Begin_Start (Condition, MCS.Schedule.Contents);
   end Begin_Start;

   procedure Tick_Boards is
   begin
      MCS.PWM_Board.Tick;
   end Tick_Boards;

   procedure Write_Outputs is
   begin
      Targets.Write_Servos (MCS.PWM_Board.Contents);
   end Write_Outputs;
   package Program is new Node_Programs
     (Name            => "MCS",
      AD_Board        => MCS.AD_Board,
      Telemetry_Board => MCS.Telemetry_Board,
      Node            => Node,
      Begin_Start     => Begin_Start,
      AD_Interrupt    => MCS.ADINT.Handle_Interrupt,
      Tick_Boards     => Tick_Boards,
      Write_Outputs   => Write_Outputs);

   procedure Run (Condition : Integer_32) is
   begin
      Program.Run (if Condition = 2 then Processor_Restart else Warm_Reset);
   end Run;

   procedure Start is
   begin
      Targets.Keep_Memory;
      Program.Run (Cold_Start);
   end Start;

   procedure On_Tick is
   begin
      Program.On_Tick;
   end On_Tick;

   procedure On_Character_Time is
   begin
      Program.On_Character_Time;
   end On_Character_Time;

   procedure On_Character (Data : Unsigned_32; Damaged : Unsigned_32) is
   begin
      Program.On_Character (Byte (Data and 255), Damaged /= 0);
   end On_Character;

   procedure On_Free_Sender is
   begin
      Program.On_Free_Sender;
   end On_Free_Sender;

   procedure On_Converted (Value : Unsigned_32) is
   begin
      Program.On_Converted (Word (Value and 16#FFF#));
   end On_Converted;

   procedure Configure (Flags : Unsigned_32; Line_Delay : Unsigned_32) is
      Set : URV.Laws.Settings := MCS.Law_Settings.Contents;
   begin
      Set.On := (Flags and 1) /= 0;
      MCS.Law_Settings.Write (Set);
      MCS.Telemetry_Board.Set_Round_Trip
        (Telemetry.Round_Trip_Of (Integer (Line_Delay)));
   end Configure;

   procedure Put_Row is
      CORE : constant URV.CORE_Memory.Memory := MCS.CORE_Memory.Contents;
      PWM  : constant PWM_Buffer :=
        URV.PWM_Layout.To_Outputs (MCS.PWM_Board.Contents);
   begin
      for Each of CORE.Uplink loop
         Put_Word (Unsigned_16 (Each));
      end loop;
      for Each of CORE.Downlink loop
         Put_Word (Unsigned_16 (Each));
      end loop;
      for Each of CORE.Status loop
         Put_Word (Unsigned_16 (Each));
      end loop;
      for Each of PWM loop
         Put_Word (Unsigned_16 (Each));
      end loop;
      Put_Line;
   end Put_Row;

   procedure Put_Counts is
   begin
      Program.Put_Counts;
   end Put_Counts;

end Bare_MCS;
