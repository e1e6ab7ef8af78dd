--  SPDX-License-Identifier: Apache-2.0

--  The state of the watchdog as the reference manual describes it, for
--  contracts (BRD-6, D-92). Between two accesses of the program written values
--  are taken: Follows permits that.

package STM32_Watchdog.Models with Pure, SPARK_Mode is

   type Watchdog_Model is record
      Runs        : Boolean;
      Is_Unlocked : Boolean;
      Divider     : Clock_Divider;
      Reload      : Reload_Value;
      Waiting     : Status;

      --  The number of times that the counter began again.
      Feeds       : Event_Number;
   end record;

   function Follows (After, Before : Watchdog_Model) return Boolean is
     (After.Runs = Before.Runs
      and then After.Is_Unlocked = Before.Is_Unlocked
      and then After.Divider = Before.Divider
      and then After.Reload = Before.Reload
      and then After.Feeds = Before.Feeds
      and then
        (if not Before.Waiting.Divider_Waits
         then not After.Waiting.Divider_Waits)
      and then
        (if not Before.Waiting.Reload_Waits
         then not After.Waiting.Reload_Waits));

   function With_Key (This : Watchdog_Model; Item : Key) return Watchdog_Model
   is
     (case Item is
         when Unlock => (This with delta Is_Unlocked => True),
         when Feed   =>
           (This with delta Is_Unlocked => False, Feeds => This.Feeds + 1),
         when Start  => (This with delta Is_Unlocked => False, Runs => True));

end STM32_Watchdog.Models;
