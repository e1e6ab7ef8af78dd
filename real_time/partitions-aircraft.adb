--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time;
with System;

with Host;                use Host;
with Host.Bench;
with Host.Loss_Times;
with Host.Recordings;
with Host.Sensor_Scripts; use Host.Sensor_Scripts;
with Partitions.Clocks;
with Partitions.Columns;  use Partitions.Columns;
with Partitions.Plant;
with Telemetry.Boards;
with URV.CORE_Memory;
with URV.LAW_Steps;
with URV.Laws;
with URV.Law_Status;
with URV.PWM_Layout;
with URV.Routing;
with URV.Surface_Monitor;
with URVOS;               use URVOS;
with URVOS.Frame_Locks;   use URVOS.Frame_Locks;
with URVOS.Frames;        use URVOS.Frames;

package body Partitions.Aircraft is

   Sensors  : Script;
   Measured : Sensor_Words := Neutral_Sensors;
   Answered : Boolean := True;

   --  The time of the servos' last command: set by one processor, read by the
   --  other.
   Servos_At : Microseconds := 0 with Atomic;

   --  The node locks its frames to the ground's; the last reported state.
   Has_Lock    : Boolean := False;
   Was_In_Step : Boolean := False;

   function Servos return PWM_Buffer is
     (URV.PWM_Layout.To_Outputs (MCS.PWM_Board.Contents));

   package Rows_Aboard is new Host.Recordings.Followers
     (MCS.Recorder.Contents, MCS.Recorder.Row_At);

   procedure Put_Recording (To : in out Host.Text_Output.Writer) is
   begin
      Rows_Aboard.Put_New_Rows (To);
   end Put_Recording;

   procedure Prepare (Chosen : Host.Options.Choices) is
      use Host.Options;
      Set : URV.Laws.Settings := MCS.Law_Settings.Contents;
   begin
      Bench.Start (Schedule => Chosen.Schedule);
      Has_Lock := Chosen.Lock;
      MCS.Frame_Lock.Set (Has_Lock);
      MCS.Recorder.Set_Length
        (Host.Recordings.Length_Of (Chosen.Recorder));
      Set.On := Chosen.Laws;
      Set.By := Loss_Times.Frames_Of (Chosen.Loss);
      MCS.Law_Settings.Write (Set);
      if Is_Given (Chosen, Sensors_Option) then
         Load (Sensors, Value (Chosen, Sensors_Option));
      end if;
      if Chosen.Plant = JSBSim_Plant then
         Plant.Start (Chosen.Schedule);
      end if;
   end Prepare;

   --  The words of the bench's sensors.
   procedure Sample_Bench;

   procedure Sample_Bench is
      Moved : Sensor_Words := Measured;
      Row   : Sensor_Words := Measured;
   begin
      Bench.Step (Servos, Moved);
      while Next_Time (Sensors) <= Clocks.Elapsed loop
         Advance (Sensors, Row);
      end loop;

      for Item in Sensor_Item loop
         Measured (Item) :=
           (if Is_Given (Sensors, Item) then Row (Item) else Moved (Item));
      end loop;
   end Sample_Bench;

   procedure Sample
     (Is_Next  : Boolean;
      Words    : out Channel_Words;
      Is_There : out Boolean) is
   begin
      if Is_Next then
         null;
      elsif Plant.Is_Present then
         Plant.Look (Measured, Answered);
      else
         Sample_Bench;
      end if;

      Is_There := Answered;
      Words := (others => Neutral_Value);
      for Item in Sensor_Item loop
         Words (URV.Routing.Channel_Of (Item)) := Measured (Item);
      end loop;
   end Sample;

   function Column_Names return String is
     (Uplink_Names ("mcs.uplink") & PWM_Names ("pwm")
      & Downlink_Names ("mcs.downlink")
      & ",link.uplink_received,link.uplink_bad,link.downlink_sent"
      & ",link.downlink_scrapped,link.mcs_resets,servos_us");

   procedure Append_Values (To : in out Row) is
      CORE  : constant URV.CORE_Memory.Memory  :=
        MCS.CORE_Memory.Contents;
      Tally : constant Telemetry.Boards.Statistics :=
        MCS.Telemetry_Board.Tally;
   begin
      Append_Uplink (To, CORE.Uplink);
      Append_PWM (To, Servos);
      Append_Downlink (To, CORE.Downlink);
      Append_Counts
        (To,
         (Tally.Received, Tally.Bad, Tally.Sent, Tally.Scrapped,
          Tally.Resets));
      Append (To, Number (Servos_At));
      To.Has_Truth := Plant.Is_Present;
      if To.Has_Truth then
         To.Truth := Plant.Truth;
      end if;
   end Append_Values;

   function Last_Names return String is
     ((if MCS.Law_Settings.Contents.On
       then ",laws.lateral,laws.vertical,laws.power,laws.link"
        & ",laws.invalid_low,laws.invalid_high,laws.silent,laws.failed"
        & ",laws.configuration"
       else "")
      & Frame_Names ("mcs.frame"));

   procedure Append_Laws (To : in out Row) is
      use URV.Law_Status;

      Kept   : constant URV.LAW_Steps.Kept := MCS.Law_Memory.Contents;
      Status : constant Report :=
        Report_Of
          (Kept.Flown, URV.Surface_Monitor.Failed_Bits (Kept.Watched),
           Kept.Set);
      Rest   : Word := Status (Active);
   begin
      if MCS.Law_Settings.Contents.On then
         for Part in 1 .. 4 loop
            Append (To, Number (Rest mod 16));
            Rest := Rest / 16;
         end loop;
         for Item in Invalid_Low .. Failed loop
            Append (To, Number (Status (Item)));
         end loop;
         Append (To, Number (Status (Configuration)));
      end if;
      Append_Frame (To, MCS.CORE_Memory.Contents.Frame);
   end Append_Laws;

   function Next_Message (Now : String) return String is
      Of_Plant : constant String := Plant.Next_Message (Now);
      State    : constant Lock_State := MCS.Frame_Lock.Contents;
   begin
      if Of_Plant /= "" or else State.Is_In_Step = Was_In_Step then
         return Of_Plant;
      end if;
      Was_In_Step := State.Is_In_Step;
      return
        (if Was_In_Step then "in step with the ground at "
         else "out of step at ") & Now & " s";
   end Next_Message;

   procedure Put_Counts
     (Result : in out Partitions.Reports.Report;
      To     : in out Host.Text_Output.Writer)
   is
      use Partitions.Reports;
      State : constant Lock_State := MCS.Frame_Lock.Contents;
   begin
      Plant.Put_Counts (Result, To);
      if Has_Lock then
         Begin_Group (Result, To, "lock");
         Put_Field
           (Result, To, "in_step",
            Reports.Number (Boolean'Pos (State.Is_In_Step)));
         Put_Field
           (Result, To, "in_step_since_frame",
            Reports.Number (State.Since / Ticks_Per_Major_Frame));
         Put_Field
           (Result, To, "frames_of_9_ticks", Reports.Number (State.Shortened));
         Put_Field
           (Result, To, "frames_of_11_ticks",
            Reports.Number (State.Lengthened));
         End_Group (Result, To);
      end if;
   end Put_Counts;

   --  The PWM board's own clock (SAF-11), beside the node's tasks. A late tick
   --  is not repeated: the controller was equally late.
   task Board_Clock with Priority => System.Priority'Last;

   task body Board_Clock is
      use Ada.Real_Time;
      Frame : constant Time_Span :=
        Ada.Real_Time.Microseconds
          (Ticks_Per_Major_Frame * Microseconds_Per_Tick);
      Next  : Time := Clock;
   begin
      loop
         Next := Next + Frame;
         delay until Next;
         for Tick in 1 .. Ticks_Per_Major_Frame loop
            MCS.PWM_Board.Tick;
         end loop;
         if Clock > Next + Frame then
            Next := Clock;
         end if;

         --  Without a controller only this task continues the plant's flight.
         if MCS.PWM_Board.Is_Unattended then
            Plant.Fly
              (Servos, Heard => MCS.Telemetry_Board.Tally.Received > 0);
         end if;
      end loop;
   end Board_Clock;

   procedure Observe (Who : MCS.Task_Name) is
      use type MCS.Task_Name;
   begin
      if Who = MCS.PWM_Task then
         Servos_At := Clocks.Machine_Time (Ada.Real_Time.Clock);
         Plant.Fly (Servos, Heard => MCS.Telemetry_Board.Tally.Received > 0);
      end if;
   end Observe;

end Partitions.Aircraft;
