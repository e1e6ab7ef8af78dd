--  SPDX-License-Identifier: Apache-2.0

--  The driver of the processor's timer (BRD-9).

with Cortex_SysTick.Models;    use Cortex_SysTick.Models;
with Cortex_SysTick.Registers; use Cortex_SysTick.Registers;

package Cortex_SysTick.Timers with SPARK_Mode is

   pragma Unevaluated_Use_Of_Old (Allow);

   --  Begins periods of this number of cycles of the processor's clock,
   --  whatever the timer was doing. The end of each one interrupts.
   procedure Start (Cycles : Cycle_Count)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       State.Counts
       and then State.Interrupts
       and then State.On_Main_Clock
       and then State.Reload = Cycles - 1
       and then State.In_Use = Cycles - 1;

   --  The periods after the present one have this number of cycles.
   procedure Set_Next (Cycles : Cycle_Count)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Follows ((State with delta Reload => State'Old.Reload), State'Old)
       and then State.Reload = Cycles - 1;

   --  Stop keeps the count of the present period, and Resume goes on from it.
   --  A period that ended before Stop stays reported.

   procedure Stop
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       not State.Counts
       and then State.Reload = State'Old.Reload
       and then
         (if State'Old.Has_Ended or else State.Periods /= State'Old.Periods
          then State.Has_Ended);

   procedure Resume
   with
     Inline,
     Global => (In_Out => Chip),
     Pre    => not State.Counts and then State.Reload in Reload_Value,
     Post   =>
       State =
         (State'Old with delta
            Counts | Interrupts | On_Main_Clock => True);

   --  The cycles until the end of the present period.
   procedure Look (Left : out Natural)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   => Follows (State, State'Old) and then Left <= State.In_Use;

   --  Is_Due: a period has ended since the last call that said so. Each end is
   --  reported by this call or by a later one.
   procedure Take_Period (Is_Due : out Boolean)
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       State.Counts = State'Old.Counts
       and then State.Reload = State'Old.Reload
       and then Is_Due =
         (State'Old.Has_Ended or else State.Periods /= State'Old.Periods)
       and then not State.Has_Ended
       and then State.Resets =
         State'Old.Resets + (if Is_Due then 1 else 0);

end Cortex_SysTick.Timers;
