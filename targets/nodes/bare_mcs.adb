--  SPDX-License-Identifier: Apache-2.0

with Devices.PWM_Board;
with Interfaces;    use Interfaces;
with Machine_Texts; use Machine_Texts;
with MCS.Bare_Metal;
with Node_Programs;
with Targets;
with URV.Buffers;   use URV.Buffers;
with URV.Laws;
with URV.PWM_Layout;
with URVOS.Starts;  use URVOS.Starts;

package body Bare_MCS is

   --  The servos' board may have lost its words at a start.
   Must_Write : Boolean := True;

   --  The words that the servos' board has.
   Written : Devices.PWM_Board.Data_Area := (others => 0);

   procedure Begin_Start (Condition : Start_Condition);

   procedure Tick_Boards;

   procedure Write_Outputs;

   procedure Set_Laws (On : Boolean);

   procedure Put_Outputs;

   procedure Begin_Start (Condition : Start_Condition) is
   begin
      Must_Write := True;
      MCS.Bare_Metal.Begin_Start (Condition, MCS.Schedule.Contents);
   end Begin_Start;

   procedure Tick_Boards is
   begin
      MCS.PWM_Board.Tick;
   end Tick_Boards;

   procedure Write_Outputs is
      Changed : Boolean;
   begin
      MCS.PWM_Board.Look_For_Change (Changed);
      if Changed or else Must_Write then
         Must_Write := False;
         Written := MCS.PWM_Board.Contents;
         Targets.Write_Servos (Written);
      end if;
   end Write_Outputs;

   procedure Set_Laws (On : Boolean) is
      Set : URV.Laws.Settings := MCS.Law_Settings.Contents;
   begin
      Set.On := On;
      MCS.Law_Settings.Write (Set);
   end Set_Laws;

   procedure Put_Outputs is
      PWM : constant PWM_Buffer := URV.PWM_Layout.To_Outputs (Written);
   begin
      for Each of PWM loop
         Put_Word (Unsigned_16 (Each));
      end loop;
   end Put_Outputs;

   package Program is new Node_Programs
     (Name            => "MCS",
      AD_Board        => MCS.AD_Board,
      Telemetry_Board => MCS.Telemetry_Board,
      Sealing         => MCS.Sealing,
      CORE_Memory     => MCS.CORE_Memory,
      Node_Status     => MCS.Status,
      Errors          => MCS.Errors,
      Node            => MCS.Bare_Metal,
      Begin_Start     => Begin_Start,
      Handle_End      => MCS.ADINT.Handle_End,
      Tick_Boards     => Tick_Boards,
      Write_Outputs   => Write_Outputs,
      Set_Laws        => Set_Laws,
      Put_Outputs     => Put_Outputs);

   procedure Start is
   begin
      Program.Start;
   end Start;

end Bare_MCS;
