--  SPDX-License-Identifier: Apache-2.0

--  From the pilot's commands to the servos (report, 4.8.4, figure 13; PWM-2,
--  D-2).

with URVOS;       use URVOS;
with URV.Buffers; use URV.Buffers;

package URV.PWM_Transform with Pure, SPARK_Mode is

   --  A switch is on from the middle of the converter's range upward (D-8).
   function Is_On (Switch : Word) return Boolean is
     (Switch >= Neutral_Value)
   with Global => null;

   --  The board's word for a command that may exceed 12 bits (D-11).
   function Clipped (Command : Word) return Converter_Value is
     (if Command in Converter_Value then Command else Converter_Value'Last)
   with Global => null;

   --  Zero degrees, and half flaps: 15 degrees.
   Flaps_Up   : constant Converter_Value := Neutral_Value;
   Flaps_Half : constant Converter_Value := 16#FFF#;

   --  The bit of a switch in the discretes: switch n is bit n - 1 (D-10).
   function Switch_Bit (Switch : Switch_Item) return Word is
     (case Switch is
         when Switch_1 => 2 ** 0,
         when Switch_2 => 2 ** 1,
         when Switch_3 => 2 ** 2,
         when Switch_4 => 2 ** 3,
         when Switch_5 => 2 ** 4,
         when Switch_6 => 2 ** 5,
         when Switch_7 => 2 ** 6,
         when Switch_8 => 2 ** 7)
   with Global => null;

   --  The eight switches packed in one byte.
   function Packed_Switches (Commands : Uplink_Buffer) return Word is
     ((if Is_On (Commands (Switch_1)) then Switch_Bit (Switch_1) else 0)
      or (if Is_On (Commands (Switch_2)) then Switch_Bit (Switch_2) else 0)
      or (if Is_On (Commands (Switch_3)) then Switch_Bit (Switch_3) else 0)
      or (if Is_On (Commands (Switch_4)) then Switch_Bit (Switch_4) else 0)
      or (if Is_On (Commands (Switch_5)) then Switch_Bit (Switch_5) else 0)
      or (if Is_On (Commands (Switch_6)) then Switch_Bit (Switch_6) else 0)
      or (if Is_On (Commands (Switch_7)) then Switch_Bit (Switch_7) else 0)
      or (if Is_On (Commands (Switch_8)) then Switch_Bit (Switch_8) else 0))
   with
     Global => null,
     Post   =>
       Packed_Switches'Result <= 255
       and then
         (for all Switch in Switch_Item =>
            ((Packed_Switches'Result and Switch_Bit (Switch)) /= 0) =
              Is_On (Commands (Switch)));

   function Flap_Command (Commands : Uplink_Buffer) return Converter_Value is
     (if Is_On (Commands (Switch_8)) then Flaps_Half else Flaps_Up)
   with Global => null;

   --  All 14 outputs (PWM-2).
   function Transform (Commands : Uplink_Buffer) return PWM_Buffer is
     (Left_Aileron | Right_Aileron            => Clipped (Commands (Roll)),
      Left_Elevator | Right_Elevator          => Clipped (Commands (Pitch)),
      Left_Rudder | Right_Rudder | Steering   => Clipped (Commands (Yaw)),
      Throttle                                => Clipped (Commands (Throttle)),
      Brake                                   => Clipped (Commands (Brake)),
      Left_Flap_1 | Right_Flap_1
        | Left_Flap_2 | Right_Flap_2          => Flap_Command (Commands),
      Discretes                               => Packed_Switches (Commands))
   with
     Global => null,
     Post   =>
       (for all Item in PWM_Item =>
          Transform'Result (Item) =
            (case Item is
                when Left_Aileron | Right_Aileron   =>
                   Clipped (Commands (Roll)),
                when Left_Elevator | Right_Elevator =>
                   Clipped (Commands (Pitch)),
                when Left_Rudder .. Steering        =>
                   Clipped (Commands (Yaw)),
                when Throttle                       =>
                   Clipped (Commands (Throttle)),
                when Brake                          =>
                   Clipped (Commands (Brake)),
                when Left_Flap_1 .. Right_Flap_2    =>
                   Flap_Command (Commands),
                when Discretes                      =>
                   Packed_Switches (Commands)))
       and then (for all Item in Servo_Item =>
                   Transform'Result (Item) in Converter_Value);

end URV.PWM_Transform;
