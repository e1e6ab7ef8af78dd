--  SPDX-License-Identifier: Apache-2.0

--  The contents of the registers of an STM32F4's analog-to-digital converter,
--  as the reference manual RM0090 defines them in section 13.13 (BRD-9). The
--  converter converts one channel at each start, when its regular sequence has
--  the length 1.

with Interfaces; use Interfaces;
with URVOS;      use URVOS;

package STM32_ADC with Pure, SPARK_Mode is

   --  The inputs 0 to 15 are pins.
   type Channel_Number is range 0 .. 15;

   subtype Converted_Value is Word range 0 .. 16#FFF#;

   --  The status register. A program resets a flag by writing 0; a 1 changes
   --  nothing. Overrun: a value was lost.

   type Status is record
      Converted : Boolean;
      Started   : Boolean;
      Overrun   : Boolean;
   end record
   with Size => 32;

   for Status use record
      Converted at 0 range 1 .. 1;
      Started   at 0 range 4 .. 4;
      Overrun   at 0 range 5 .. 5;
   end record;

   --  Control register 1. The resolution stays 12 bits.

   type Control_1 is record
      End_Interrupt     : Boolean;
      Overrun_Interrupt : Boolean;
   end record
   with Size => 32;

   for Control_1 use record
      End_Interrupt     at 0 range 5 .. 5;
      Overrun_Interrupt at 0 range 26 .. 26;
   end record;

   --  Control register 2. With Each_End the converter shows the end of each
   --  conversion and detects overruns. The values are aligned to the right.

   type Control_2 is record
      Is_On    : Boolean;
      Each_End : Boolean;
   end record
   with Size => 32;

   for Control_2 use record
      Is_On    at 0 range 0 .. 0;
      Each_End at 0 range 10 .. 10;
   end record;

   --  The sampling time of all channels, in cycles of the converter's clock. A
   --  conversion takes 12 cycles more.

   type Sampling_Time is
     (Cycles_3, Cycles_15, Cycles_28, Cycles_56, Cycles_84, Cycles_112,
      Cycles_144, Cycles_480);

   --  Numbers of events; they wrap around, and are only compared.
   type Event_Number is new Unsigned_32;

end STM32_ADC;
