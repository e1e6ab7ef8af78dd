--  SPDX-License-Identifier: Apache-2.0

--  The messages between the tasks: converter images, uplink and downlink
--  buffers, servo commands (report, section 2.5, figures 4 and 13, D-15).
--
--  A buffer is an array over the names of its words. The order of the names is
--  the order on the wire (BUF-1, BUF-2).

with Devices.AD_Board;
with URVOS; use URVOS;

package URV.Buffers with Pure, SPARK_Mode is

   --  A word of a sensor or a stick carries one converter value (BUF-3).
   subtype Converter_Value is Word range 0 .. 16#FFF#;

   --  The middle of the converter's range: a centred stick, a surface at
   --  zero degrees.
   Neutral_Value : constant Converter_Value := 16#800#;

   --  The bits of the error/status word. Stale_Data: the words are those of an
   --  earlier frame (report, 4.1.3; SAF-5); a task sets it when it has no new
   --  scan, or passes on old words. ROM_Differs and Self_Test_Failed concern
   --  the node that sends the message (TST-4). Other_Kind: an uplink carries
   --  no commands, but a block of another kind (EXT-2).
   No_Error         : constant Word := 0;
   Stale_Data       : constant Word := 1;
   ROM_Differs      : constant Word := 2;
   Self_Test_Failed : constant Word := 4;
   Other_Kind       : constant Word := 8;

   --  The words that the analog-to-digital board samples in one scan.
   type Channel is new Devices.AD_Board.Channel_Number;
   type Channel_Words is array (Channel) of Word;

   --  33 words: one for each channel, then the error/status word.
   type AD_Image is record
      Words        : Channel_Words;
      Error_Status : Word;
   end record;

   --  Pilot's console to aircraft, 14 words (figure 4a).
   type Uplink_Item is
     (Roll, Pitch, Yaw, Throttle, Brake,
      Switch_1, Switch_2, Switch_3, Switch_4,
      Switch_5, Switch_6, Switch_7, Switch_8,
      Error_Status);

   subtype Command_Item is Uplink_Item range Roll .. Switch_8;
   subtype Switch_Item is Uplink_Item range Switch_1 .. Switch_8;

   type Uplink_Buffer is array (Uplink_Item) of Word;

   --  Aircraft to ground, 28 words (figure 4b).
   type Downlink_Item is
     (Right_Flap_1, Left_Flap_1, Right_Flap_2, Left_Flap_2,
      Right_Aileron, Left_Aileron, Right_Elevator, Left_Elevator,
      Right_Rudder, Left_Rudder,
      Alpha, Beta, Altitude_Offset,
      Lateral_Acceleration, Longitudinal_Acceleration, Vertical_Acceleration,
      RPM, Battery_Volts, Alternator_Volts,
      Roll_Attitude, Pitch_Attitude, Roll_Rate, Pitch_Rate, Yaw_Rate,
      Airspeed, Altitude, Uplink_Signal_Strength,
      Error_Status);

   subtype Sensor_Item is
     Downlink_Item range Right_Flap_1 .. Uplink_Signal_Strength;

   type Downlink_Buffer is array (Downlink_Item) of Word;

   --  The frame of a downlink (FTI-12, D-98): the number of the aircraft's
   --  frame of its scan, modulo 4096; the slot of the running test card, 0 for
   --  none; its phase; seven servo words. The phase of a running card is its
   --  frame modulo 16. Without one it is the reason of the last end, by its
   --  place in URV.Test_Runs.Verdict.
   type Frame_Item is
     (Frame_Number, Running_Card, Card_Phase,
      Left_Aileron, Right_Aileron, Left_Elevator, Right_Elevator,
      Left_Rudder, Right_Rudder, Throttle);

   subtype Shown_Servo is Frame_Item range Left_Aileron .. Throttle;

   type Frame_Words is array (Frame_Item) of Word;

   --  The number of frame numbers.
   Frame_Numbers : constant := 4_096;

   --  A word that a downlink does not carry.
   Unknown_Word : constant Word := Word'Last;

   Unknown_Frame : constant Frame_Words := (others => Unknown_Word);

   --  A downlink with its frame, for CORE.
   type Framed_Downlink is record
      Words : Downlink_Buffer;
      Frame : Frame_Words;
   end record;

   --  The words for the pulse width modulation board (figure 13b): 13 servo
   --  commands and the eight discretes, with switch n in bit n - 1.
   type PWM_Item is
     (Left_Aileron, Right_Aileron, Left_Elevator, Right_Elevator,
      Left_Rudder, Right_Rudder, Steering, Throttle, Brake,
      Left_Flap_1, Right_Flap_1, Left_Flap_2, Right_Flap_2,
      Discretes);

   subtype Servo_Item is PWM_Item range Left_Aileron .. Right_Flap_2;

   type PWM_Buffer is array (PWM_Item) of Word;

   --  The safe words (SAF-1, D-13), which the outputs hold from power up until
   --  the first commands arrive: throttle idle, brake full on, all else at
   --  zero degrees, the switches off.
   Safe_Outputs : constant PWM_Buffer :=
     (Throttle  => Converter_Value'First,
      Brake     => Converter_Value'Last,
      Discretes => 0,
      others    => Neutral_Value);

   --  The "previous values" for a consumer that has not received a message
   --  (INI-8, D-13). The error word is set because nothing was measured. The
   --  commands mean the safe outputs; the sensors are at the middle of their
   --  range.
   Neutral_Uplink : constant Uplink_Buffer :=
     (Throttle     => Converter_Value'First,
      Brake        => Converter_Value'Last,
      Switch_Item  => 0,
      Error_Status => Stale_Data,
      others       => Neutral_Value);

   Neutral_Downlink : constant Downlink_Buffer :=
     (Error_Status => Stale_Data, others => Neutral_Value);

   function Neutral_Framed_Downlink return Framed_Downlink is
     (Words => Neutral_Downlink, Frame => Unknown_Frame)
   with Global => null;

   --  The same, as the channels of each node's converter have them: the
   --  ground's carry the commands, the aircraft's the sensors.
   Neutral_Stick_Words : constant Channel_Words :=
     (3       => Converter_Value'First,
      4       => Converter_Value'Last,
      5 .. 12 => 0,
      others  => Neutral_Value);

   Neutral_Sensor_Words : constant Channel_Words :=
     (others => Neutral_Value);

   function Neutral_Stick_Image return AD_Image is
     (Words => Neutral_Stick_Words, Error_Status => Stale_Data)
   with Global => null;

   function Neutral_Sensor_Image return AD_Image is
     (Words => Neutral_Sensor_Words, Error_Status => Stale_Data)
   with Global => null;

   --  A buffer with the node's own bits in its error/status word (TST-4).

   function Marked
     (Source : Uplink_Buffer;
      Status : Word) return Uplink_Buffer
   is
     (for Item in Uplink_Item =>
        (if Item = Error_Status then Source (Item) or Status
         else Source (Item)))
   with Global => null;

   function Marked
     (Source : Downlink_Buffer;
      Status : Word) return Downlink_Buffer
   is
     (for Item in Downlink_Item =>
        (if Item = Error_Status then Source (Item) or Status
         else Source (Item)))
   with Global => null;

   --  The same in place

   procedure Mark (This : in out Uplink_Buffer; Status : Word)
   with
     Inline,
     Global => null,
     Post   => This = Marked (This'Old, Status);

   procedure Mark (This : in out Downlink_Buffer; Status : Word)
   with
     Inline,
     Global => null,
     Post   => This = Marked (This'Old, Status);

   --  A buffer marked as of an earlier frame; whether one is so marked (SAF-5)

   function As_Old (Source : Uplink_Buffer) return Uplink_Buffer is
     (Marked (Source, Stale_Data))
   with Global => null;

   function As_Old (Source : Downlink_Buffer) return Downlink_Buffer is
     (Marked (Source, Stale_Data))
   with Global => null;

   function Is_Old (Source : Uplink_Buffer) return Boolean is
     ((Source (Error_Status) and Stale_Data) /= 0)
   with Global => null;

   function Is_Old (Source : Downlink_Buffer) return Boolean is
     ((Source (Error_Status) and Stale_Data) /= 0)
   with Global => null;

end URV.Buffers;
