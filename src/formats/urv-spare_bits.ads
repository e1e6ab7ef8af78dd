--  SPDX-License-Identifier: Apache-2.0

--  The spare bits of a downlink (FTI-12, D-98). A sensor's word has 12 bits of
--  a converter and four spare ones above them. These carry the frame of the
--  downlink:
--
--     word   1        mark
--     words  2 to 4   number of the frame
--     word   5        slot of the running card, 0 for none
--     word   6        its phase
--     words  7 to 27  seven servo words
--
--  A value of 12 bits takes three words, its highest bits first. Words are
--  limited to 12 bits before, so that no spare bit comes from a sensor.
--
--  A block without a mark has no frame: that of an older aircraft, or of one
--  that failed its self-test. Its words are taken as they are. The marks
--  differ from those of format 2 (URV.Seal_Blocks), by which a node in format
--  1 refuses sealed blocks. A sealed block has no spare bits; its number and
--  its card's byte become those of the frame, without servo words.

with URVOS;       use URVOS;
with URV.Buffers; use URV.Buffers;

package URV.Spare_Bits with Pure, SPARK_Mode is

   subtype Nibble is Word range 0 .. 15;

   Frame_Mark     : constant Nibble := 5;
   No_Servos_Mark : constant Nibble := 6;

   Word_Bits  : constant Word := 16#0FFF#;
   Spare_Unit : constant Word := 16#1000#;

   function Spare_Of (Value : Word) return Nibble is (Value / Spare_Unit)
   with Global => null;

   function Without_Spare (Value : Word) return Converter_Value is
     (Value and Word_Bits)
   with Global => null;

   --  A word that a fault has made larger than 12 bits goes down as the
   --  largest one (D-11).
   function Clipped (Value : Word) return Converter_Value is
     (if Value > Word_Bits then Word_Bits else Value)
   with Global => null;

   --  The frames that can be sent.
   function Is_Sendable (Frame : Frame_Words) return Boolean is
     (Frame (Frame_Number) <= Word_Bits
      and then Frame (Running_Card) <= Nibble'Last
      and then Frame (Card_Phase) <= Nibble'Last
      and then
        (for all Item in Shown_Servo => Frame (Item) <= Word_Bits))
   with Global => null;

   --  The three parts of a value of 12 bits.

   function High (Value : Word) return Nibble is ((Value / 256) and 15)
   with Global => null;

   function Middle (Value : Word) return Nibble is ((Value / 16) and 15)
   with Global => null;

   function Low (Value : Word) return Nibble is (Value and 15)
   with Global => null;

   --  The spare bits of a word.
   function Sent_With (Frame : Frame_Words; Item : Downlink_Item)
                       return Nibble
   is
     (case Item is
         when Right_Flap_1           => Frame_Mark,
         when Left_Flap_1            => High (Frame (Frame_Number)),
         when Right_Flap_2           => Middle (Frame (Frame_Number)),
         when Left_Flap_2            => Low (Frame (Frame_Number)),
         when Right_Aileron          => Low (Frame (Running_Card)),
         when Left_Aileron           => Low (Frame (Card_Phase)),
         when Right_Elevator         => High (Frame (Left_Aileron)),
         when Left_Elevator          => Middle (Frame (Left_Aileron)),
         when Right_Rudder           => Low (Frame (Left_Aileron)),
         when Left_Rudder            => High (Frame (Right_Aileron)),
         when Alpha                  => Middle (Frame (Right_Aileron)),
         when Beta                   => Low (Frame (Right_Aileron)),
         when Altitude_Offset        => High (Frame (Left_Elevator)),
         when Lateral_Acceleration   => Middle (Frame (Left_Elevator)),
         when Longitudinal_Acceleration => Low (Frame (Left_Elevator)),
         when Vertical_Acceleration  => High (Frame (Right_Elevator)),
         when RPM                    => Middle (Frame (Right_Elevator)),
         when Battery_Volts          => Low (Frame (Right_Elevator)),
         when Alternator_Volts       => High (Frame (Left_Rudder)),
         when Roll_Attitude          => Middle (Frame (Left_Rudder)),
         when Pitch_Attitude         => Low (Frame (Left_Rudder)),
         when Roll_Rate              => High (Frame (Right_Rudder)),
         when Pitch_Rate             => Middle (Frame (Right_Rudder)),
         when Yaw_Rate               => Low (Frame (Right_Rudder)),
         when Airspeed               => High (Frame (Throttle)),
         when Altitude               => Middle (Frame (Throttle)),
         when Uplink_Signal_Strength => Low (Frame (Throttle)),
         when others                 => 0)
   with Global => null;

   --  The same of a sealed block, by the word's place in it, from 1: the low
   --  12 bits of its number, and its card's byte, the card above its phase

   Card_Place  : constant := Downlink_Item'Pos (Right_Aileron) + 1;
   Phase_Place : constant := Downlink_Item'Pos (Left_Aileron) + 1;

   function Sealed_With (Number, Card : Word; Place : Positive) return Nibble
   is
     (case Place is
         when Downlink_Item'Pos (Right_Flap_1) + 1 => No_Servos_Mark,
         when Downlink_Item'Pos (Left_Flap_1) + 1  => High (Number),
         when Downlink_Item'Pos (Right_Flap_2) + 1 => Middle (Number),
         when Downlink_Item'Pos (Left_Flap_2) + 1  => Low (Number),
         when Card_Place                           => Middle (Card),
         when Phase_Place                          => Low (Card),
         when others                               => 0)
   with Global => null;

   --  A downlink with its frame in the spare bits.
   function Packed (Source : Downlink_Buffer; Frame : Frame_Words)
                    return Downlink_Buffer
   is
     ([for Item in Downlink_Item =>
         (if Item = Error_Status then Source (Item)
          else Clipped (Source (Item))
            or Sent_With (Frame, Item) * Spare_Unit)])
   with Global => null;

   --  The same in place.
   procedure Pack (This : in out Downlink_Buffer; Frame : Frame_Words)
   with
     Global => null,
     Post   => This = Packed (This'Old, Frame);

   --  The same after the link

   function Is_Marked (Source : Downlink_Buffer) return Boolean is
     (Spare_Of (Source (Downlink_Item'First)) in Frame_Mark | No_Servos_Mark)
   with Global => null;

   --  The words of the sensors, and the error/status word.
   function Sensors_In (Source : Downlink_Buffer) return Downlink_Buffer is
     ([for Item in Downlink_Item =>
         (if Item /= Error_Status and then Is_Marked (Source)
          then Without_Spare (Source (Item))
          else Source (Item))])
   with Global => null;

   function Joined (One, Two, Three : Word) return Converter_Value is
     (Spare_Of (One) * 256 or Spare_Of (Two) * 16 or Spare_Of (Three))
   with Global => null;

   function Carried (Source : Downlink_Buffer; Which : Frame_Item)
                     return Word
   is
     (case Which is
         when Frame_Number   =>
           Joined (Source (Left_Flap_1), Source (Right_Flap_2),
                   Source (Left_Flap_2)),
         when Running_Card   => Spare_Of (Source (Right_Aileron)),
         when Card_Phase     => Spare_Of (Source (Left_Aileron)),
         when Left_Aileron   =>
           Joined (Source (Right_Elevator), Source (Left_Elevator),
                   Source (Right_Rudder)),
         when Right_Aileron  =>
           Joined (Source (Left_Rudder), Source (Alpha), Source (Beta)),
         when Left_Elevator  =>
           Joined (Source (Altitude_Offset), Source (Lateral_Acceleration),
                   Source (Longitudinal_Acceleration)),
         when Right_Elevator =>
           Joined (Source (Vertical_Acceleration), Source (RPM),
                   Source (Battery_Volts)),
         when Left_Rudder    =>
           Joined (Source (Alternator_Volts), Source (Roll_Attitude),
                   Source (Pitch_Attitude)),
         when Right_Rudder   =>
           Joined (Source (Roll_Rate), Source (Pitch_Rate),
                   Source (Yaw_Rate)),
         when Throttle       =>
           Joined (Source (Airspeed), Source (Altitude),
                   Source (Uplink_Signal_Strength)))
   with Global => null;

   function Is_Carried (Source : Downlink_Buffer; Which : Frame_Item)
                        return Boolean
   is
     (Spare_Of (Source (Downlink_Item'First)) = Frame_Mark
      or else
        (Spare_Of (Source (Downlink_Item'First)) = No_Servos_Mark
         and then Which not in Shown_Servo))
   with Global => null;

   --  The frame; Unknown_Word for each word that the block does not carry.
   function Frame_In (Source : Downlink_Buffer) return Frame_Words is
     ([for Which in Frame_Item =>
         (if Is_Carried (Source, Which) then Carried (Source, Which)
          else Unknown_Word)])
   with Global => null;

   --  All of a downlink.
   function Unpacked (Source : Downlink_Buffer) return Framed_Downlink is
     ((Words => Sensors_In (Source), Frame => Frame_In (Source)))
   with Global => null;

   --  The same in place.
   procedure Unpack
     (Words : in out Downlink_Buffer; Frame : out Frame_Words)
   with
     Global => null,
     Post   =>
       Words = Sensors_In (Words'Old) and then Frame = Frame_In (Words'Old);

end URV.Spare_Bits;
