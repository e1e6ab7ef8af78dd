--  SPDX-License-Identifier: Apache-2.0

with Devices.AD_Board;
with Telemetry;
with Telemetry.Senders; use Telemetry.Senders;
with URVOS.Task_Trees;
with URV.Buffers;       use URV.Buffers;
with URVOS.Frames;      use URVOS.Frames;

package body Sim.Numbers is

   Up   : constant Positive :=
     Positive (Message_Length (Telemetry.Uplink_Length));
   Down : constant Positive :=
     Positive (Message_Length (Telemetry.Downlink_Length));

   procedure Print (To : in out Text_Output.Writer) is

      procedure Put
        (Name : String; Value : Natural; Before : String := ",");

      procedure Put
        (Name : String; Value : Natural; Before : String := ",") is
      begin
         Text_Output.Put_Line (To, Before);
         Text_Output.Put (To, "  """ & Name & """:" & Value'Image);
      end Put;

   begin
      Put ("tick_us", Microseconds_Per_Tick, Before => "{");
      Put ("frame_ticks", Ticks_Per_Major_Frame);
      Put ("frame_us", Frame_Length);
      Put ("character_us", Telemetry.Microseconds_Per_Character);
      Put ("conversion_us", Devices.AD_Board.Microseconds_Per_Conversion);
      Put ("channels", Channel_Words'Length);
      Put ("servo_tick", Servo_Tick (URVOS.Task_Trees.Report));
      Put ("uplink_words", Uplink_Buffer'Length);
      Put ("downlink_words", Downlink_Buffer'Length);
      Put ("pwm_words", PWM_Buffer'Length);
      Put ("uplink_characters", Up);
      Put ("downlink_characters", Down);

      --  The ground answers a downlink that it has requested.
      Put ("exchange_up_characters", Up + 2);
      Put ("exchange_down_characters", Down + 1);
      Put ("dead_space_characters", Natural (Telemetry.Dead_Space));
      Put ("guard_characters", Natural (Telemetry.Guard_Time));
      Put ("idle_characters", Natural (Telemetry.Idle_Time));
      Text_Output.New_Line (To);
      Text_Output.Put_Line (To, "}");
   end Print;

end Sim.Numbers;
