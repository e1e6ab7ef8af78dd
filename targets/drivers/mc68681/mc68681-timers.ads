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
       State (Chip).Runs
       and then State (Chip).Auxiliary = Timer_On_Own_Clock
       and then Count_Of (State (Chip)) = Half_Period
       and then State (Chip).Interrupts = State (Chip)'Old.Interrupts
       and then State (Chip).Vector = State (Chip)'Old.Vector;

   --  Is_Due: a period has ended since the last call that said so. The end of
   --  each period is reported by this call or by a later one.
   procedure Take_Period (Chip : Chip_Name; Is_Due : out Boolean)
   with
     Inline,
     Global => (In_Out => Chips),
     Post   =>
       State (Chip).Runs = State (Chip)'Old.Runs
       and then
         (if State (Chip).Periods /= State (Chip)'Old.Periods
            or else State (Chip)'Old.Is_Due
          then Is_Due or else State (Chip).Is_Due)
       and then
         (if Is_Due
          then State (Chip).Due_Resets =
            State (Chip)'Old.Due_Resets + 1
          else State (Chip).Due_Resets =
            State (Chip)'Old.Due_Resets);

   --  The chip interrupts at the end of a period, and with Receiver also when
   --  channel A has received a character, with this vector.
   procedure Use_Interrupts
     (Chip     : Chip_Name;
      Vector   : Byte;
      Receiver : Boolean)
   with
     Global => (In_Out => Chips),
     Post   =>
       State (Chip).Vector = Vector
       and then
         State (Chip).Interrupts =
           (Timer => True, Receiver_A => Receiver, others => False)
       and then State (Chip).Runs = State (Chip)'Old.Runs;

end MC68681.Timers;
