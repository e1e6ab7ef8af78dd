--  SPDX-License-Identifier: Apache-2.0

--  The contents of the registers of an STM32's independent watchdog, as the
--  reference manual defines them (BRD-6, BRD-7). Its clock is an oscillator of
--  its own, with 17 to 47 kHz. Its counter runs down from the reload value; at
--  0 it resets the chip. Only a reset stops it.

with Interfaces; use Interfaces;

package STM32_Watchdog with Pure, SPARK_Mode is

   --  The keys of the key register. Unlock permits the next writes of divider
   --  and reload value; each other key ends that.

   type Key is (Unlock, Feed, Start);

   --  Counts a second are the clock's frequency divided by this.

   type Clock_Divider is (By_4, By_8, By_16, By_32, By_64, By_128, By_256);

   subtype Reload_Value is Natural range 0 .. 4_095;

   --  A written value waits until the watchdog's clock has taken it.

   type Status is record
      Divider_Waits : Boolean;
      Reload_Waits  : Boolean;
   end record
   with Alignment => 2;

   --  A number of events; it wraps around, and is only compared.
   type Event_Number is new Unsigned_32;

end STM32_Watchdog;
