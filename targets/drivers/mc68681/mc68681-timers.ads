--  SPDX-License-Identifier: Apache-2.0

--  The driver of a chip's timer and of its interrupts (BRD-6).

with MC68681.Models;    use MC68681.Models;
with MC68681.Registers; use MC68681.Registers;

package MC68681.Timers with SPARK_Mode is

   pragma Unevaluated_Use_Of_Old (Allow);

   --  Begins the periods of the timer, each of twice this count of the chip's
   --  clock.
   procedure Start (Chip : Chip_Name; Half_Period : Timer_Count)
   with
     Global => (In_Out => Chips),
     Post   =>
       Chips_Now (Chip).Runs
       and then Chips_Now (Chip).Auxiliary = Timer_On_Own_Clock
       and then Count_Of (Chips_Now (Chip)) = Half_Period
       and then Chips_Now (Chip).Interrupts = Chips_Now'Old (Chip).Interrupts
       and then Chips_Now (Chip).Vector = Chips_Now'Old (Chip).Vector;

   --  Is_Due: a period has ended since the last call that said so. The end of
   --  each period is reported by this call or by a later one.
   procedure Take_Period (Chip : Chip_Name; Is_Due : out Boolean)
   with
     Global => (In_Out => Chips),
     Post   =>
       Chips_Now (Chip).Runs = Chips_Now'Old (Chip).Runs
       and then
         (if Chips_Now (Chip).Periods /= Chips_Now'Old (Chip).Periods
            or else Chips_Now'Old (Chip).Is_Due
          then Is_Due or else Chips_Now (Chip).Is_Due)
       and then
         (if Is_Due
          then Chips_Now (Chip).Due_Resets =
            Chips_Now'Old (Chip).Due_Resets + 1
          else Chips_Now (Chip).Due_Resets =
            Chips_Now'Old (Chip).Due_Resets);

   --  The chip interrupts at the end of a period, and with Receiver also when
   --  channel A has received a character, with this vector.
   procedure Use_Interrupts
     (Chip     : Chip_Name;
      Vector   : Byte;
      Receiver : Boolean)
   with
     Global => (In_Out => Chips),
     Post   =>
       Chips_Now (Chip).Vector = Vector
       and then
         Chips_Now (Chip).Interrupts =
           (Timer => True, Receiver_A => Receiver, others => False)
       and then Chips_Now (Chip).Runs = Chips_Now'Old (Chip).Runs;

end MC68681.Timers;
