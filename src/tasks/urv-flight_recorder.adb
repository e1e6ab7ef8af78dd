--  SPDX-License-Identifier: Apache-2.0

with Devices.PWM_Board;
with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URV.Card_Status;
with URV.CORE_Layout;   use URV.CORE_Layout;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Errors;        use URV.Errors;
with URV.LAW_Steps;
with URV.Law_Status;    use URV.Law_Status;
with URV.PWM_Layout;
with URV.Recorder_Rows; use URV.Recorder_Rows;
with URV.Surface_Monitor;

package body URV.Flight_Recorder with SPARK_Mode is

   procedure Take_Laws (Words : in out Recorded_Words)
   with Global => (Input => Law_Memory);

   procedure Take_Errors (Words : in out Recorded_Words)
   with Global => (Input => Errors);

   procedure Take_Laws (Words : in out Recorded_Words) is
      Kept   : constant URV.LAW_Steps.Kept := Law_Memory.Contents;
      Report : constant Law_Status.Report  := Law_Status.Report_Of
        (Kept.Flown, Surface_Monitor.Failed_Bits (Kept.Watched), Kept.Set);
   begin
      Words.Laws :=
        (Report (Active), Report (Invalid_Low), Report (Invalid_High),
         Report (Silent), Report (Failed), Report (Configuration));
      Words.Cards := Card_Status.State_Word (Kept.Cards.Run);
   end Take_Laws;

   procedure Take_Errors (Words : in out Recorded_Words) is
      Log  : constant Error_Log  := Errors.Contents;
      Time : constant Clock_Tick := Errors.Time;
   begin
      Words.Time := Time;
      Words.Errors := To_Word (Logs.Total (Log));
      Words.Kind :=
        (if Logs.Total (Log) = 0 then 0
         else Error_Kind'Pos (Logs.Latest (Log)) + 1);
      Words.Starts := To_Word
        (Saturating_Sum
           (Logs.History_Of (Log, Warm_Reset).Occurrences,
            Logs.History_Of (Log, Processor_Restart).Occurrences));
   end Take_Errors;

   procedure Record_Frame is
      Uplink   : constant Coded_Uplink   := CORE_Memory.Uplink_Area;
      Downlink : constant Coded_Downlink := CORE_Memory.Downlink_Area;
      Area     : constant Devices.PWM_Board.Data_Area := PWM_Board.Contents;
      Words    : Recorded_Words;
   begin
      Words.Sensors := Downlink.Words;
      Words.Commands := Uplink.Words;
      Words.Servos := PWM_Layout.To_Outputs (Area);
      Take_Laws (Words);
      Take_Errors (Words);
      Recorder.Take (Words);
   end Record_Frame;

end URV.Flight_Recorder;
