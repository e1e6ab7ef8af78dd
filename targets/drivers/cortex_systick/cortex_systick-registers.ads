--  SPDX-License-Identifier: Apache-2.0

--  Access to the registers of the timer, one access of the bus each (BRD-9,
--  D-92).
--
--  This is a boundary of the proof: a contract here is what the reference
--  manual says of the register, and which conditions it sets. On the Cortex-M4
--  the body reads and writes the register. In the tests the body is a
--  simulated chip, which executes these contracts.

with Cortex_SysTick.Models; use Cortex_SysTick.Models;

package Cortex_SysTick.Registers
  with
    SPARK_Mode,
    Abstract_State => Chip,
    Initializes    => Chip
is

   pragma Unevaluated_Use_Of_Old (Allow);

   function State return Timer_Model
   with Ghost, Global => Chip;

   --  Periods may have ended just before. The first one begins with the reload
   --  value.
   procedure Write_Control (Value : Control)
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => (if Value.Counts then State.Reload in Reload_Value),
     Post   =>
       Follows
         ((State with delta
             Counts        => State'Old.Counts,
             Interrupts    => State'Old.Interrupts,
             On_Main_Clock => State'Old.On_Main_Clock),
          State'Old)
       and then State = With_Control (State, Value);

   --  Resets the flag.
   procedure Read_Control (Value : out Control)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       not State.Has_Ended
       and then Follows
         ((State with delta
             Has_Ended => Value.Has_Ended,
             Resets    => State'Old.Resets),
          State'Old)
       and then State = With_Control (State, Value)
       and then State.Resets =
         State'Old.Resets + (if Value.Has_Ended then 1 else 0);

   procedure Write_Reload (Value : Reload_Value)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Follows ((State with delta Reload => State'Old.Reload), State'Old)
       and then State.Reload = Value;

   --  Any write sets the count to 0 and resets the flag. A timer that counts,
   --  or is then started, begins a period.
   procedure Clear_Current
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => not State.Counts,
     Post   =>
       State =
         (State'Old with delta
            In_Use    => State'Old.Reload,
            Has_Ended => False);

   --  The cycles until the end of the present period.
   procedure Read_Current (Left : out Natural)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   => Follows (State, State'Old) and then Left <= State.In_Use;

end Cortex_SysTick.Registers;
