--  SPDX-License-Identifier: Apache-2.0

package body STM32_Watchdog.Timers with SPARK_Mode is

   --  The start switches the watchdog's clock on, which takes the values.
   procedure Start (Value : Reload_Value) is
   begin
      Write_Key (STM32_Watchdog.Start);
      Write_Key (Unlock);
      Write_Divider (By_32);
      Write_Reload (Value);
      Write_Key (STM32_Watchdog.Feed);
   end Start;

   procedure Feed is
   begin
      Write_Key (STM32_Watchdog.Feed);
   end Feed;

end STM32_Watchdog.Timers;
