--  SPDX-License-Identifier: Apache-2.0

--  Access to the registers of the converter, one access of the bus each
--  (BRD-9, D-92).
--
--  This is a boundary of the proof: a contract here is what the reference
--  manual says of the register, and which conditions it sets. On the Cortex-M4
--  the body reads and writes the register. In the tests the body is a
--  simulated chip, which executes these contracts.

with STM32_ADC.Models; use STM32_ADC.Models;

package STM32_ADC.Registers
  with
    SPARK_Mode,
    Abstract_State => Chip,
    Initializes    => Chip
is

   pragma Unevaluated_Use_Of_Old (Allow);

   --  The state of the converter, and the result of a conversion. A result
   --  does not change.

   function State return Converter_Model
   with Ghost, Global => Chip;

   function Value_Of (Number : Event_Number) return Converted_Value
   with Ghost, Global => null;

   --  Resets the flags that are False in Value, and no other one.
   procedure Write_Status (Value : Status)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => not State.Converting or else Value.Converted,
     Post   =>
       Follows
         ((State with delta
             Converted =>
               (if Value.Converted then State.Converted
                else State'Old.Converted),
             Overrun   =>
               (if Value.Overrun then State.Overrun
                elsif State.Losses = State'Old.Losses
                then State'Old.Overrun else True)),
          State'Old)
       and then (if not Value.Converted then not State.Converted)
       and then (if not Value.Overrun then not State.Overrun);

   procedure Read_Status (Item : out Status)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Follows (State, State'Old) and then Shows (Item, State);

   procedure Write_Control_1 (Value : Control_1)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Follows (State, (State'Old with delta Settings => Value));

   --  Without a start.
   procedure Write_Control_2 (Value : Control_2)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       State.More = Value
       and then
         (if Value.Is_On
          then Follows (State, (State'Old with delta More => Value))
          else Is_Stopped (State, State'Old));

   --  Sampling time and sequence change only while nothing is converted: at
   --  other times a write begins the conversion again.

   procedure Write_Sampling (Value : Sampling_Time)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => not State.Converting,
     Post   => State = (State'Old with delta Sampling => Value);

   --  The sequence has this channel alone.
   procedure Write_Channel (Value : Channel_Number)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => not State.Converting,
     Post   => State = (State'Old with delta Channel => Value);

   --  Starts a conversion.
   procedure Write_Start
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    =>
       State.More.Is_On
       and then State.More.Each_End
       and then not State.Converting,
     Post   => State = With_Start (State'Old);

   --  The present value, or an old one if there is none.
   procedure Read_Data (Data : out Converted_Value)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Is_Read (State, State'Old)
       and then
         (if State'Old.Converted
            or else (State'Old.Converting and then not State.Converting)
          then Data = Value_Of (State.Present));

end STM32_ADC.Registers;
