--  SPDX-License-Identifier: Apache-2.0

--  The driver of the converter: one conversion of one channel at each start
--  (BRD-9).

with STM32_ADC.Models;    use STM32_ADC.Models;
with STM32_ADC.Registers; use STM32_ADC.Registers;

package STM32_ADC.Conversions with SPARK_Mode is

   pragma Unevaluated_Use_Of_Old (Allow);

   --  Ready for a start.
   function Is_Ready (This : Converter_Model) return Boolean is
     (This.More = (Is_On => True, Each_End => True)
      and then not This.Converting);

   --  The result of one call of Take. Overrun: values were lost since the last
   --  report. Then none is given: its channel would be uncertain.
   type Reception is record
      Is_There : Boolean         := False;
      Value    : Converted_Value := 0;
      Overrun  : Boolean         := False;
   end record;

   --  Switches the converter on, whatever it was doing, and forgets all
   --  values. With Interrupt the end of a conversion interrupts, and so does
   --  an overrun. The caller then waits for 3 us: the converter settles.
   procedure Set_Up (Sampling : Sampling_Time; Interrupt : Boolean)
   with
     Global => (In_Out => Chip),
     Post   =>
       Is_Ready (State)
       and then State.Settings = (others => Interrupt)
       and then State.Sampling = Sampling
       and then not State.Converted
       and then not State.Overrun
       and then State.Started = State'Old.Started;

   --  Starts a conversion. A value that was not taken is lost when it ends.
   procedure Start (Channel : Channel_Number)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => Is_Ready (State),
     Post   =>
       State =
         With_Start ((State'Old with delta Channel => Channel));

   --  Takes the value of a conversion that has ended. Each value is given once
   --  and is that of its conversion, or its loss is reported by this call.
   procedure Take (Result : out Reception)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Same_Settings (State, State'Old)
       and then (if not State'Old.Converting then not State.Converting)
       and then
         (if Result.Is_There
          then not Result.Overrun
            and then Result.Value =
              Value_Of
                (if State'Old.Converted then State'Old.Present
                 else State'Old.Started))
       and then
         (if State'Old.Converted
          then Result.Is_There or else Result.Overrun)
       and then
         Result.Overrun =
           (State'Old.Overrun or else State.Losses /= State'Old.Losses)
       and then not State.Overrun
       and then
         (if State.Converted
          then State.Present = State'Old.Started
            and then State'Old.Converting
            and then not State.Converting);

end STM32_ADC.Conversions;
