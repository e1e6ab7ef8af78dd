--  SPDX-License-Identifier: Apache-2.0

--  The contents of the registers of a Cortex-M's SysTick, as the ARMv7-M
--  reference manual defines them in section B3.3 (BRD-9). The timer counts
--  down from the reload value to 0, and then begins again.

with Interfaces; use Interfaces;

package Cortex_SysTick with Pure, SPARK_Mode is

   --  Has_Ended: the count has come to 0 since the last read of this register,
   --  which resets it. A write does not change it.

   type Control is record
      Counts        : Boolean;
      Interrupts    : Boolean;
      On_Main_Clock : Boolean;
      Has_Ended     : Boolean;
   end record
   with Size => 32;

   for Control use record
      Counts        at 0 range 0 .. 0;
      Interrupts    at 0 range 1 .. 1;
      On_Main_Clock at 0 range 2 .. 2;
      Has_Ended     at 0 range 16 .. 16;
   end record;

   subtype Reload_Value is Natural range 1 .. 16#FF_FFFF#;

   --  The cycles of a period are one more.
   subtype Cycle_Count is Natural range 2 .. 16#100_0000#;

   --  Numbers of events; they wrap around, and are only compared.
   type Event_Number is new Unsigned_32;

end Cortex_SysTick;
