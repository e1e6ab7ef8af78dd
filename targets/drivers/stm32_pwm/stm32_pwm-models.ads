--  SPDX-License-Identifier: Apache-2.0

--  The state of a timer as the reference manual describes it, for contracts
--  (BRD-9, D-92). Just before an access of the program the counter may begin
--  again: Follows permits that.

package STM32_PWM.Models with Pure, SPARK_Mode is

   type Compare_Values is array (Output_Number) of Register_16;

   --  Two sets of these values: those written, and those in use. An update
   --  event takes the written ones.
   type Value_Set is record
      Prescaler : Register_16;
      Reload    : Register_16;
      Compare   : Compare_Values;
   end record;

   type Mode_List is array (Output_Pair) of Modes;

   type Timer_Model is record
      Settings   : Control;
      Modes      : Mode_List;
      Switches   : Outputs;
      Written    : Value_Set;
      In_Use     : Value_Set;
   end record;

   No_Output : constant Outputs := (others => False);

   --  All written values wait for the update, and no other ones come into use.
   function Is_Saved (This : Timer_Model) return Boolean is
     (This.Settings.Reload_Is_Saved
      and then
        (for all Pair in Output_Pair =>
           This.Modes (Pair).First_Is_Saved
           and then This.Modes (Pair).Second_Is_Saved));

   function Same_Settings (One, Other : Timer_Model) return Boolean is
     (One.Settings = Other.Settings
      and then
        (for all Pair in Output_Pair =>
           One.Modes (Pair).First_Is_Saved = Other.Modes (Pair).First_Is_Saved
           and then One.Modes (Pair).First = Other.Modes (Pair).First
           and then One.Modes (Pair).Second_Is_Saved =
             Other.Modes (Pair).Second_Is_Saved
           and then One.Modes (Pair).Second = Other.Modes (Pair).Second)
      and then One.Switches = Other.Switches);

   --  Up to the update event the values in use stay: all of them if all are
   --  saved.
   function Follows (After, Before : Timer_Model) return Boolean is
     (Same_Settings (After, Before)
      and then After.Written = Before.Written
      and then
        (if not Is_Saved (Before) then True
         elsif Before.Settings.Counts
         then After.In_Use in Before.In_Use | Before.Written
         else After.In_Use = Before.In_Use));

   function Updated (This : Timer_Model) return Timer_Model is
     ((This with delta In_Use => This.Written));

   --  Pulses of 1 to 2 ms each 20 ms

   function Are_Pulses (Item : Value_Set) return Boolean is
     (Item.Prescaler = Clock_MHz - 1
      and then Item.Reload = Period - 1
      and then
        (for all Output in Output_Number =>
           Item.Compare (Output) in Pulse));

   --  Whatever the outputs show, now and later, is a servo's pulse, if the
   --  program writes only pulses: a written value waits for the end of the
   --  period, so no pulse is cut or longer.
   function Makes_Pulses (This : Timer_Model) return Boolean is
     (Is_Saved (This)
      and then
        (for all Pair in Output_Pair =>
           This.Modes (Pair).First = PWM_1
           and then This.Modes (Pair).Second = PWM_1)
      and then Are_Pulses (This.Written)
      and then Are_Pulses (This.In_Use));

   --  The servos get no output, or pulses.
   function Is_Safe (This : Timer_Model) return Boolean is
     (This.Switches = No_Output or else Makes_Pulses (This));

end STM32_PWM.Models;
