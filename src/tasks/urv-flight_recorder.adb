--  SPDX-License-Identifier: Apache-2.0

with Devices.PWM_Board;
with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URV.CORE_Layout;   use URV.CORE_Layout;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Errors;        use URV.Errors;
with URV.PWM_Layout;
with URV.Recorder_Rows; use URV.Recorder_Rows;

package body URV.Flight_Recorder with SPARK_Mode is

   procedure Take_Errors (Words : in out Recorded_Words)
   with Global => (Input => Errors);

   procedure Take_Errors (Words : in out Recorded_Words) is
      All_Errors : constant Logs.Summary := Errors.Summary;
      Resets     : constant Logs.History := Errors.History_Of (Warm_Reset);
      Restarts   : constant Logs.History :=
        Errors.History_Of (Processor_Restart);
      Time       : constant Clock_Tick   := Errors.Time;
   begin
      Words.Time := Time;
      Words.Errors := To_Word (All_Errors.Total);
      Words.Kind :=
        (if All_Errors.Total = 0 then 0
         else Error_Kind'Pos (All_Errors.Latest) + 1);
      Words.Starts := Word'Min
        (To_Word (Saturating_Sum (Resets.Occurrences, Restarts.Occurrences)),
         Byte_Word'Last);
   end Take_Errors;

   procedure Record_Frame is
      Uplink   : constant Coded_Uplink   := CORE_Memory.Uplink_Area;
      Downlink : constant Coded_Downlink := CORE_Memory.Downlink_Area;
      Area     : constant Devices.PWM_Board.Data_Area := PWM_Board.Contents;
      Laws     : constant Recorded_Laws  := Law_Record.Contents;
      Words    : Recorded_Words;
   begin
      Words.Sensors := Downlink.Words;
      Words.Commands := Uplink.Words;
      Words.Servos := PWM_Layout.To_Outputs (Area);
      Words.Laws := Laws.Laws;
      Words.Cards := Laws.Cards;
      Take_Errors (Words);
      Recorder.Take (Words);
   end Record_Frame;

end URV.Flight_Recorder;
