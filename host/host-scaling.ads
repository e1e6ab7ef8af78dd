--  SPDX-License-Identifier: Apache-2.0

--  The engineering units of every word: the only table of the simulation, for
--  every sensor, servo channel and stick. There are no signal conditioners
--  (D-49).
--
--  A converter is linear over its 4096 words. Words of surfaces and sticks are
--  centred: 0800h is zero. On both sides of the aircraft, positive rolls it
--  right, pitches its nose up, turns its nose right or lowers a flap.

with Host.Text_Output;

package Host.Scaling is

   type Unit is
     (Degrees, Degrees_Per_Second, Feet, Knots, Standard_Gravity,
      Revolutions_Per_Minute, Volts, Decibel_Milliwatts, Percent, On_Off);

   --  As written in files: "deg", "ft", "%".
   function Symbol (Of_Unit : Unit) return String;

   --  A word's value is At_0 + Per_Word * word.
   type Scale is record
      Measured_In : Unit;
      At_0        : Long_Float;
      Per_Word    : Long_Float;
   end record;

   type Sensor_Scales is array (Sensor_Item) of Scale;
   type Servo_Scales  is array (Servo_Item) of Scale;
   type Stick_Scales  is array (Command_Item) of Scale;

   --  Words beyond the converter's range are on the same line.
   function To_Unit (Value : Word; Item : Scale) return Long_Float is
     (Item.At_0 + Item.Per_Word * Long_Float (Value));

   --  The nearest word; the first or last one for a value beyond the range,
   --  the first for not-a-number.
   function To_Word (Value : Long_Float; Item : Scale) return Converter_Value;

   --  Prints every word of the three buffers and of the control laws, one a
   --  line, as CSV (GND-11):
   --  name,buffer,position,unit,at_0,at_4095, then the four limits of
   --  Host.Limits, then per_word,zero_word: the value of a word is per_word *
   --  (word - zero_word). Positions count from 1 as in figures 4 and 13 of the
   --  report. The last two columns, label,works, are for switches only
   --  (Host.Names): its function, and the part that it works. A column is
   --  empty where an item has none: the scale of error/status, discretes and
   --  the laws' words, limits of all but sensors.
   procedure Print (To : in out Text_Output.Writer)
     with Pre => Text_Output.Is_Open (To);

   --  A scale whose word 0800h is zero.
   function Centred (Measured_In : Unit; Per_Word : Long_Float)
                     return Scale is
     ((Measured_In, -2_048.0 * Per_Word, Per_Word));

   --  A servo's command and its sensor's position have the same scale, so that
   --  their words can be compared.
   Aileron  : constant Scale := Centred (Degrees, 0.01);
   Elevator : constant Scale := Centred (Degrees, 0.012_5);
   Rudder   : constant Scale := Centred (Degrees, 0.012_5);
   Steering_Angle : constant Scale := Centred (Degrees, 0.005);

   --  0fffh is the half flap position, 15 degrees (report, 4.8.4).
   Flap     : constant Scale := Centred (Degrees, 15.0 / 2_047.0);

   --  Idle to full over the whole range: 0800h is half.
   Lever    : constant Scale := (Percent, 0.0, 100.0 / 4_095.0);

   --  Released at 0800h, full at 0fffh. Below 0800h the brakes are released.
   Pedal    : constant Scale := Centred (Percent, 100.0 / 2_047.0);

   --  A stick's full deflection is 100 per cent, slightly less on one side.
   Deflection : constant Scale := Centred (Percent, 100.0 / 2_048.0);

   --  0 is off, 1 is on; the threshold is 0800h (D-8), one half.
   Switch   : constant Scale := (On_Off, 0.0, 1.0 / 4_095.0);

   Sensors : constant Sensor_Scales :=
     (Right_Flap_1 | Left_Flap_1 | Right_Flap_2 | Left_Flap_2 => Flap,
      Right_Aileron  | Left_Aileron  => Aileron,
      Right_Elevator | Left_Elevator => Elevator,
      Right_Rudder   | Left_Rudder   => Rudder,
      Alpha | Beta                   => Centred (Degrees, 0.012_5),

      --  Height above sea level at which Altitude reads zero.
      Altitude_Offset           => (Feet, 0.0, 4.0),

      Lateral_Acceleration      => Centred (Standard_Gravity, 0.001),
      Longitudinal_Acceleration => Centred (Standard_Gravity, 0.001),

      --  The load factor: 1 in level flight.
      Vertical_Acceleration     => Centred (Standard_Gravity, 0.004),

      RPM                       => (Revolutions_Per_Minute, 0.0, 2.0),
      Battery_Volts             => (Volts, 0.0, 0.01),
      Alternator_Volts          => (Volts, 0.0, 0.01),
      Roll_Attitude             => Centred (Degrees, 180.0 / 2_048.0),
      Pitch_Attitude            => Centred (Degrees, 90.0 / 2_048.0),
      Roll_Rate                 => Centred (Degrees_Per_Second, 0.05),
      Pitch_Rate                => Centred (Degrees_Per_Second, 0.025),
      Yaw_Rate                  => Centred (Degrees_Per_Second, 0.025),
      Airspeed                  => (Knots, 0.0, 0.031_25),
      Altitude                  => (Feet, 0.0, 0.5),

      --  At the aircraft's receiver. The range ends where reception fails.
      Uplink_Signal_Strength    => (Decibel_Milliwatts, -120.0, 0.025));

   Servos : constant Servo_Scales :=
     (Left_Aileron  | Right_Aileron  => Aileron,
      Left_Elevator | Right_Elevator => Elevator,
      Left_Rudder   | Right_Rudder   => Rudder,
      Steering                       => Steering_Angle,
      Throttle                       => Lever,
      Brake                          => Pedal,
      Left_Flap_1 | Right_Flap_1 | Left_Flap_2 | Right_Flap_2 => Flap);

   Sticks : constant Stick_Scales :=
     (Roll | Pitch | Yaw => Deflection,
      Throttle           => Lever,
      Brake              => Pedal,
      Switch_Item        => Switch);

end Host.Scaling;
