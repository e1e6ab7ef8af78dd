--  SPDX-License-Identifier: Apache-2.0

--  The state of the timer as the reference manual describes it, for contracts
--  (BRD-9, D-92). Just before an access of the program periods may end:
--  Follows permits that.

package Cortex_SysTick.Models with Pure, SPARK_Mode is

   type Timer_Model is record
      Counts        : Boolean;
      Interrupts    : Boolean;
      On_Main_Clock : Boolean;

      --  The reload value written, and that of the present period. A period
      --  that begins takes the written one.
      Reload        : Natural;
      In_Use        : Natural;

      --  The periods that have ended since power up, and the flag. An end sets
      --  it. The number of its resets.
      Periods       : Event_Number;
      Has_Ended     : Boolean;
      Resets        : Event_Number;
   end record;

   function Follows (After, Before : Timer_Model) return Boolean is
     (After.Counts = Before.Counts
      and then After.Interrupts = Before.Interrupts
      and then After.On_Main_Clock = Before.On_Main_Clock
      and then After.Reload = Before.Reload
      and then After.Resets = Before.Resets
      and then
        (if After.Periods = Before.Periods
         then After.Has_Ended = Before.Has_Ended
           and then After.In_Use = Before.In_Use
         else Before.Counts
           and then After.Has_Ended
           and then After.In_Use = Before.Reload));

   function With_Control
     (This : Timer_Model;
      Item : Control) return Timer_Model
   is
     ((This with delta
         Counts        => Item.Counts,
         Interrupts    => Item.Interrupts,
         On_Main_Clock => Item.On_Main_Clock));

end Cortex_SysTick.Models;
