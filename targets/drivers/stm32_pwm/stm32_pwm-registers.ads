--  SPDX-License-Identifier: Apache-2.0

--  Access to the registers of the timers, one access of the bus each (BRD-9,
--  D-92). An output may show each state that a register has: the contracts
--  therefore demand safe states (Is_Safe).
--
--  This is a boundary of the proof: a contract here is what the reference
--  manual says of the register. On the Cortex-M4 the body writes the register.
--  In the tests the body is a simulated chip, which executes these contracts.

with STM32_PWM.Models; use STM32_PWM.Models;

package STM32_PWM.Registers
  with
    SPARK_Mode,
    Abstract_State => Chip,
    Initializes    => Chip
is

   pragma Unevaluated_Use_Of_Old (Allow);

   function State (Timer : Timer_Name) return Timer_Model
   with Ghost, Global => Chip;

   procedure Write_Control (Timer : Timer_Name; Value : Control)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    =>
       State (Timer).Switches = No_Output
       or else Value.Reload_Is_Saved,
     Post   =>
       Follows
         (State (Timer), (State (Timer)'Old with delta Settings => Value));

   procedure Write_Modes
     (Timer : Timer_Name;
      Pair  : Output_Pair;
      Value : Modes)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => State (Timer).Switches = No_Output,
     Post   =>
       Follows
         (State (Timer),
          (State (Timer)'Old with delta
             Modes => (State (Timer)'Old.Modes with delta Pair => Value)));

   procedure Write_Outputs (Timer : Timer_Name; Value : Outputs)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => Value = No_Output or else Makes_Pulses (State (Timer)),
     Post   =>
       Follows
         (State (Timer), (State (Timer)'Old with delta Switches => Value));

   procedure Write_Prescaler (Timer : Timer_Name; Value : Register_16)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => State (Timer).Switches = No_Output,
     Post   =>
       Follows
         (State (Timer),
          (State (Timer)'Old with delta
             Written =>
               (State (Timer)'Old.Written with delta Prescaler => Value)));

   procedure Write_Reload (Timer : Timer_Name; Value : Register_16)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => State (Timer).Switches = No_Output,
     Post   =>
       Follows
         (State (Timer),
          (State (Timer)'Old with delta
             Written =>
               (State (Timer)'Old.Written with delta Reload => Value)));

   --  The end of the period may come just before the write, and just after it.
   procedure Write_Compare
     (Timer  : Timer_Name;
      Output : Output_Number;
      Value  : Register_16)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    =>
       State (Timer).Switches = No_Output or else Value in Pulse,
     Post   =>
       Same_Settings (State (Timer), State (Timer)'Old)
       and then State (Timer).Written =
         (State (Timer)'Old.Written with delta
            Compare =>
              (State (Timer)'Old.Written.Compare with delta
                 Output => Value))
       and then
         (if not Is_Saved (State (Timer)'Old) then True
          elsif State (Timer)'Old.Settings.Counts
          then State (Timer).In_Use in
              State (Timer)'Old.In_Use | State (Timer)'Old.Written
              | State (Timer).Written
          else State (Timer).In_Use = State (Timer)'Old.In_Use);

   --  An update event, and the counter begins again.
   procedure Generate_Update (Timer : Timer_Name)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => State (Timer).Switches = No_Output,
     Post   => State (Timer) = Updated (State (Timer)'Old);

end STM32_PWM.Registers;
