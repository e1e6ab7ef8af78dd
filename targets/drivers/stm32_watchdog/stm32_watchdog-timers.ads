--  SPDX-License-Identifier: Apache-2.0

--  The driver of the watchdog (BRD-6, BRD-7).
--
--  The divider is 32: the counter takes at least 0.68 ms for a count, with the
--  fastest clock that the data sheet permits, and at most 1.88 ms.

with STM32_Watchdog.Models;    use STM32_Watchdog.Models;
with STM32_Watchdog.Registers; use STM32_Watchdog.Registers;

package STM32_Watchdog.Timers with SPARK_Mode is

   pragma Unevaluated_Use_Of_Old (Allow);

   --  The fastest and the slowest clock, in Hz.
   Fastest_Clock : constant := 47_000;
   Slowest_Clock : constant := 17_000;
   Divided_By    : constant := 32;

   --  The least and the greatest time between the last call of Feed and the
   --  reset, in ms, with this reload value. The first count may be short.

   function Least_Time (Value : Reload_Value) return Natural is
     (Integer'Max (Value - 1, 0) * Divided_By * 1_000 / Fastest_Clock);

   function Greatest_Time (Value : Reload_Value) return Natural is
     (((Value + 1) * Divided_By * 1_000 + Slowest_Clock - 1) / Slowest_Clock);

   --  The reload value that leaves the program at least this time.
   subtype Time_Limit is Positive range 1 .. 2_000;

   function Reload_For (Time : Time_Limit) return Reload_Value is
     ((Time * Fastest_Clock + Divided_By * 1_000 - 1) / (Divided_By * 1_000)
      + 1)
   with
     Post => Least_Time (Reload_For'Result) >= Time;

   --  Starts the watchdog after a reset of the chip. Until the first call of
   --  Feed its time is that of the reset values, at least 348 ms.
   procedure Start (Value : Reload_Value)
   with
     Global => (In_Out => Chip),
     Pre    =>
       not State.Runs
       and then not State.Waiting.Divider_Waits
       and then not State.Waiting.Reload_Waits,
     Post   =>
       State.Runs
       and then not State.Is_Unlocked
       and then State.Divider = By_32
       and then State.Reload = Value;

   --  The counter begins again.
   procedure Feed
   with
     Inline,
     Global => (In_Out => Chip),
     Post   =>
       Follows (State, With_Key (State'Old, STM32_Watchdog.Feed));

end STM32_Watchdog.Timers;
