--  SPDX-License-Identifier: Apache-2.0

--  The contents of the registers of an STM32F4's general-purpose timers 2 to
--  5, as the reference manual RM0090 defines them in section 18.4, for the
--  pulses of servos (BRD-9): one each 20 ms, of 1 to 2 ms.

with Interfaces; use Interfaces;
with URVOS;      use URVOS;

package STM32_PWM with Pure, SPARK_Mode is

   --  Four timers with four outputs each.
   type Timer_Name is (Timer_2, Timer_3, Timer_4, Timer_5);

   type Output_Number is range 1 .. 4;

   subtype Register_16 is Natural range 0 .. 16#FFFF#;

   --  A counter counts from 0 to the value of reload, and begins again: an
   --  update event. Its clock is that of the timer divided by the prescaler's
   --  value + 1.

   type Control is record
      Counts          : Boolean;
      Reload_Is_Saved : Boolean;   --  a written value waits for the update
   end record
   with Size => 32;

   for Control use record
      Counts          at 0 range 0 .. 0;
      Reload_Is_Saved at 0 range 7 .. 7;
   end record;

   --  The modes of two outputs. In the first PWM mode an output is high while
   --  the counter is below its compare value.

   type Output_Mode is
     (Frozen, High_On_Match, Low_On_Match, Toggle, Low, High, PWM_1, PWM_2);

   type Output_Pair is (Outputs_1_2, Outputs_3_4);

   type Modes is record
      First_Is_Saved  : Boolean;   --  a compare value waits for the update
      First           : Output_Mode;
      Second_Is_Saved : Boolean;
      Second          : Output_Mode;
   end record
   with Size => 32;

   for Modes use record
      First_Is_Saved  at 0 range 3 .. 3;
      First           at 0 range 4 .. 6;
      Second_Is_Saved at 0 range 11 .. 11;
      Second          at 0 range 12 .. 14;
   end record;

   --  The outputs that are on, high when active.

   type Outputs is record
      Output_1_On : Boolean;
      Output_2_On : Boolean;
      Output_3_On : Boolean;
      Output_4_On : Boolean;
   end record
   with Size => 32;

   for Outputs use record
      Output_1_On at 0 range 0 .. 0;
      Output_2_On at 0 range 4 .. 4;
      Output_3_On at 0 range 8 .. 8;
      Output_4_On at 0 range 12 .. 12;
   end record;

   --  The timers' clock has 84 MHz, at 168 MHz of the processor. The counters
   --  count microseconds.

   Clock_MHz : constant := 84;
   Period    : constant := 20_000;

   subtype Pulse is Register_16 range 1_000 .. 2_000;

   type Pulse_List is array (Output_Number) of Pulse;

   --  The pulse of a servo's word of 12 bits, in microseconds. A larger word
   --  has the longest pulse.
   function Pulse_Of (Value : Word) return Pulse is
     (1_000 + Natural'Min (Natural (Value), 16#FFF#) * 1_000 / 16#FFF#)
   with
     Global => null,
     Post   =>
       (if Value = 0 then Pulse_Of'Result = 1_000)
       and then (if Value = 16#800# then Pulse_Of'Result = 1_500)
       and then (if Value >= 16#FFF# then Pulse_Of'Result = 2_000);

   --  Numbers of events; they wrap around, and are only compared.
   type Event_Number is new Unsigned_32;

end STM32_PWM;
