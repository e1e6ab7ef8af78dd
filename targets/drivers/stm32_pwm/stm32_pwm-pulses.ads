--  SPDX-License-Identifier: Apache-2.0

--  The driver of the servos' pulses (BRD-9): one each 20 ms at each output, of
--  1 to 2 ms. The contracts of the registers let the outputs show nothing
--  else.

with STM32_PWM.Models;    use STM32_PWM.Models;
with STM32_PWM.Registers; use STM32_PWM.Registers;

package STM32_PWM.Pulses with SPARK_Mode is

   pragma Unevaluated_Use_Of_Old (Allow);

   All_Outputs : constant Outputs := (others => True);

   function Is_Set_Up (This : Timer_Model) return Boolean is
     (This.Settings = (Counts => True, Reload_Is_Saved => True)
      and then This.Switches = All_Outputs
      and then Makes_Pulses (This));

   --  Starts these pulses at all outputs of a timer, whatever the timer was
   --  doing.
   procedure Set_Up (Timer : Timer_Name; Lengths : Pulse_List)
   with
     Global => (In_Out => Chip),
     Post   =>
       Is_Set_Up (State (Timer))
       and then
         (for all Output in Output_Number =>
            State (Timer).Written.Compare (Output) = Lengths (Output)
            and then State (Timer).In_Use.Compare (Output) =
              Lengths (Output));

   --  The pulses of an output from the next period on.
   procedure Write
     (Timer  : Timer_Name;
      Output : Output_Number;
      Length : Pulse)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => Is_Set_Up (State (Timer)),
     Post   =>
       Is_Set_Up (State (Timer))
       and then State (Timer).Written.Compare =
         (State (Timer)'Old.Written.Compare with delta Output => Length);

end STM32_PWM.Pulses;
