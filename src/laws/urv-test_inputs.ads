--  SPDX-License-Identifier: Apache-2.0

--  The signal of a test card, and its addition to the servos' words (FTI-3,
--  FTI-6, D-85).
--  Whole numbers only, so that the same card moves the same words on every
--  machine.

with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Frame_Times;   use URV.Frame_Times;
with URV.Law_Gains;     use URV.Law_Gains;
with URV.Law_Inputs;
with URV.Law_Units;     use URV.Law_Units;
with URV.Signal_Tables; use URV.Signal_Tables;
with URV.Test_Cards;    use URV.Test_Cards;

package URV.Test_Inputs with Pure, SPARK_Mode is

   --  Phases are parts of a cycle. A sine of 0.01 Hz moves by Fine_Parts a
   --  frame.
   Fine_Parts : constant := 64;
   Cycle      : constant := 100 * Frames_Per_Second * Fine_Parts;

   subtype Phase_Number is Integer range 0 .. Cycle - 1;

   pragma Compile_Time_Error
     (Cycle > 1_000_000, "the products of phases overflow for this frame");

   --  A test input in words of a surface, a stick, or a law's command.
   subtype Increment is Law_Inputs.Increment;

   type Increments is array (Test_Surface) of Increment
   with Component_Size => 16;

   Nothing_Added : constant Increments := (others => 0);

   --  The largest movement of an input in a frame.
   function Rate_Step (Which : Test_Surface) return Number is
     (case Which is
         when Left_Aileron  | Right_Aileron  => Roll_Step,
         when Left_Elevator | Right_Elevator => Pitch_Step,
         when Left_Rudder   | Right_Rudder   => Yaw_Step)
   with
     Global => null,
     Post   => Rate_Step'Result in 1 .. 1_000;

   --  The sine of a phase, linear between the table's places.
   function Sine (Phase : Phase_Number) return Unit_Value
   with Global => null;

   --  The movement of the phase in a frame: the frequency in parts of 0.01 Hz.
   subtype Fine_Frequency is Integer range 0 .. Most_Frequency * Fine_Parts;

   function Frequency_At (Source : Card; Frame : Frame_Count)
                          return Fine_Frequency
   with
     Global => null,
     Pre    => Is_Loaded (Source) and then Frame < Length_Of (Source);

   function Next_Phase
     (Source : Card; Frame : Frame_Count; Phase : Phase_Number)
      return Phase_Number
   is
     ((Phase + Frequency_At (Source, Frame)) mod Cycle)
   with
     Global => null,
     Pre    => Is_Loaded (Source) and then Frame < Length_Of (Source);

   --  The signal of a card for a surface, before the limit of its rate.
   function Signal
     (Source : Card;
      Frame  : Frame_Count;
      Phase  : Phase_Number;
      Which  : Test_Surface) return Increment
   with
     Global => null,
     Pre    => Is_Loaded (Source) and then Frame < Length_Of (Source),
     Post   =>
       abs Signal'Result <= Integer (Source (Amplitude))
       and then (if not Moves (Source, Which) then Signal'Result = 0);

   --  The servo of a surface.
   function Servo_Of (Which : Test_Surface) return Servo_Item is
     (case Which is
         when Left_Aileron   => Left_Aileron,
         when Right_Aileron  => Right_Aileron,
         when Left_Elevator  => Left_Elevator,
         when Right_Elevator => Right_Elevator,
         when Left_Rudder    => Left_Rudder,
         when Right_Rudder   => Right_Rudder)
   with Global => null;

   --  A servo's word with its input; it remains within the converter's range.
   function Word_With (Value : Converter_Value; Added : Increment)
                       return Converter_Value
   is
     (if Added = 0 then Value
      else Word_Of
        (Within (Demand_Of (Value) + Added, Demand'First, Demand'Last)))
   with
     Global => null,
     Post   =>
       (if Added = 0 then Word_With'Result = Value)
       and then
         abs (Demand_Of (Word_With'Result) - Demand_Of (Value)) <= abs Added;

   --  The servos' words with their inputs. The other outputs do not change.
   function With_Inputs (Source : PWM_Buffer; Added : Increments)
                         return PWM_Buffer
   is
     ((Source with delta
         Left_Aileron   =>
           Word_With (Source (Left_Aileron), Added (Left_Aileron)),
         Right_Aileron  =>
           Word_With (Source (Right_Aileron), Added (Right_Aileron)),
         Left_Elevator  =>
           Word_With (Source (Left_Elevator), Added (Left_Elevator)),
         Right_Elevator =>
           Word_With (Source (Right_Elevator), Added (Right_Elevator)),
         Left_Rudder    =>
           Word_With (Source (Left_Rudder), Added (Left_Rudder)),
         Right_Rudder   =>
           Word_With (Source (Right_Rudder), Added (Right_Rudder))))
   with
     Global => null,
     Pre    =>
       (for all Item in Servo_Item => Source (Item) in Converter_Value),
     Post   =>
       (for all Item in Servo_Item =>
          With_Inputs'Result (Item) in Converter_Value)
       and then
         (for all Item in PWM_Item range Steering .. Discretes =>
            With_Inputs'Result (Item) = Source (Item))
       and then
         (for all Which in Test_Surface =>
            (if Added (Which) = 0
             then With_Inputs'Result (Servo_Of (Which)) =
               Source (Servo_Of (Which)))
            and then
              abs (Demand_Of (With_Inputs'Result (Servo_Of (Which)))
                   - Demand_Of (Source (Servo_Of (Which)))) <=
                abs Added (Which))
       and then
         (if Added = Nothing_Added then With_Inputs'Result = Source);

end URV.Test_Inputs;
