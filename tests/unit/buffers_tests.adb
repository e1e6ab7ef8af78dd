--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Handling; use Ada.Characters.Handling;

with AUnit.Assertions; use AUnit.Assertions;

with Checks;       use Checks;
with Expectations; use Expectations;
with URVOS;        use URVOS;
with Telemetry;
with URV.Buffers;  use URV.Buffers;

package body Buffers_Tests is

   --  The tests, in order.
   procedure Uplink_Layout;
   procedure Downlink_Layout;
   procedure Image_Layout;
   procedure Converter_Values;
   procedure Neutral_Values;
   procedure PWM_Layout;

   --  The lists of the requirements: one word for each name, in order.
   Uplink_Names : constant String :=
     "roll pitch yaw throttle brake switch_1 switch_2 switch_3 switch_4 "
     & "switch_5 switch_6 switch_7 switch_8 error_status ";

   Downlink_Names : constant String :=
     "right_flap_1 left_flap_1 right_flap_2 left_flap_2 "
     & "right_aileron left_aileron right_elevator left_elevator "
     & "right_rudder left_rudder alpha beta altitude_offset "
     & "lateral_acceleration longitudinal_acceleration "
     & "vertical_acceleration rpm battery_volts alternator_volts "
     & "roll_attitude pitch_attitude roll_rate pitch_rate yaw_rate "
     & "airspeed altitude uplink_signal_strength error_status ";

   --  The names of a type's values, in order.
   generic
      type Item is (<>);
   function Names return String;

   function Names return String is

      function Names_From (First : Item) return String is
        (To_Lower (First'Image) & " "
         & (if First = Item'Last then ""
            else Names_From (Item'Succ (First))));

   begin
      return Names_From (Item'First);
   end Names;

   function Uplink_Item_Names is new Names (Uplink_Item);
   function Downlink_Item_Names is new Names (Downlink_Item);

   procedure Uplink_Layout is
      Buffer : constant Uplink_Buffer := Neutral_Uplink;
   begin
      Assert (Uplink_Item_Names, Uplink_Names, "names of the uplink words");
      Expect_Number ("words of an uplink buffer", Buffer'Length, 14);
      Expect_Number ("bits of an uplink buffer", Uplink_Buffer'Size, 14 * 16);
      Expect_Number ("bytes on the wire", Telemetry.Uplink_Length, 28);
      Expect_Number
        ("position of the error word", Uplink_Item'Pos (Error_Status), 14 - 1);
      Expect_Number
        ("number of commands", Uplink_Item'Pos (Command_Item'Last) + 1, 13);
      Expect_Number ("position of switch 1", Uplink_Item'Pos (Switch_1), 5);
      Expect_Number ("position of switch 8", Uplink_Item'Pos (Switch_8), 12);
   end Uplink_Layout;

   procedure Downlink_Layout is
      Buffer : constant Downlink_Buffer := Neutral_Downlink;
   begin
      Assert
        (Downlink_Item_Names, Downlink_Names, "names of the downlink words");
      Expect_Number ("words of a downlink buffer", Buffer'Length, 28);
      Expect_Number
        ("bits of a downlink buffer", Downlink_Buffer'Size, 28 * 16);
      Expect_Number ("bytes on the wire", Telemetry.Downlink_Length, 56);
      Expect_Number
        ("position of the error word (D-1)", Downlink_Item'Pos (Error_Status),
         28 - 1);
   end Downlink_Layout;

   procedure Image_Layout is
   begin
      Expect_Number ("channels", Channel_Words'Length, 32);
      Expect_Number ("first channel", Integer (Channel'First), 0);
      Expect_Number ("last channel", Integer (Channel'Last), 31);
      Expect_Number ("bits of an image", AD_Image'Size, 33 * 16);
   end Image_Layout;

   procedure Converter_Values is
   begin
      Expect ("least converter value", Converter_Value'First, 0);
      Expect ("greatest converter value", Converter_Value'Last, 16#FFF#);
      Expect ("neutral value", Neutral_Value, 16#800#);
      Expect ("0FFFh is one", 16#FFF# in Converter_Value, True);
      Expect ("1000h is one", Word'(16#1000#) in Converter_Value, False);
   end Converter_Values;

   procedure Neutral_Values is
   begin
      for Item in Uplink_Item loop
         Expect
           ("neutral uplink, " & Item'Image, Neutral_Uplink (Item),
            (case Item is
                when Roll | Pitch | Yaw => 16#800#,
                when Throttle           => 0,
                when Brake              => 16#FFF#,
                when Switch_Item        => 0,
                when Error_Status       => Stale_Data));
      end loop;
      for Item in Sensor_Item loop
         Expect
           ("neutral downlink, " & Item'Image, Neutral_Downlink (Item),
            16#800#);
      end loop;
      Expect
        ("neutral downlink, error", Neutral_Downlink (Error_Status),
         Stale_Data);
      for Number in Channel loop
         Expect
           ("neutral sensors, channel" & Number'Image,
            Neutral_Sensor_Image.Words (Number), 16#800#);
         Expect
           ("neutral sticks, channel" & Number'Image,
            Neutral_Stick_Image.Words (Number),
            (case Number is
                when 3 | 5 .. 12 => 0,
                when 4           => 16#FFF#,
                when others      => 16#800#));
      end loop;
      Expect
        ("neutral sensors, error", Neutral_Sensor_Image.Error_Status,
         Stale_Data);
      Expect
        ("neutral sticks, error", Neutral_Stick_Image.Error_Status,
         Stale_Data);
   end Neutral_Values;

   procedure PWM_Layout is
   begin
      Expect_Number ("words for the PWM board", PWM_Buffer'Length, 14);
      Expect_Number ("servos", Servo_Item'Pos (Servo_Item'Last) + 1, 13);
      Expect_Number
        ("position of the discretes", PWM_Item'Pos (Discretes), 13);
   end PWM_Layout;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "BUF-1 an uplink buffer is 14 words in the given order",
         Uplink_Layout'Access);
      Add
        (Suite, "BUF-2 a downlink buffer is 28 words in the given order",
         Downlink_Layout'Access);
      Add
        (Suite, "BUF-3 an image is 32 channel words and an error word",
         Image_Layout'Access);
      Add
        (Suite, "BUF-3 a converter value has 12 bits",
         Converter_Values'Access);
      Add
        (Suite, "INI-8 D-13 neutral buffers are safe and say they are stale",
         Neutral_Values'Access);
      Add
        (Suite, "PWM-2 the PWM board gets 13 servo words and discretes",
         PWM_Layout'Access);
   end Add_To;

end Buffers_Tests;
