--  SPDX-License-Identifier: Apache-2.0

--  A check of the program image, long by long, in slices of any length
--  (report, 2.4; TST-1, TST-3). It only reads.
--
--     Read (Check.Position, Data);
--     Take_Long (Check, Data, Outcome);
--
--  After the last long the pass is counted as good or bad, and the next one
--  begins at the first long. A wrong sum shows that some long is wrong, not
--  which.

with URVOS.Image_Sums; use URVOS.Image_Sums;
with URVOS.Memories;   use URVOS.Memories;

generic
   --  The last long of the image, including its sum.
   Last : Long_Address;
package URVOS.ROM_Checks with Pure, SPARK_Mode is

   subtype Place is Long_Address range 0 .. Last;

   type Check is record
      --  The next long to read, and the sum of those before it.
      Position : Place := 0;
      Sums     : Sum   := First_Value;

      --  The numbers of passes with a right and a wrong image.
      Good_Passes : Count := 0;
      Bad_Passes  : Count := 0;
   end record;

   New_Check : constant Check := (others => <>);

   type Outcome_Kind is (Under_Way, Found_Good, Found_Bad);

   --  The outcome of one more long.
   function Outcome_Of (This : Check; Data : Long) return Outcome_Kind is
     (if This.Position < Last then Under_Way
      elsif Next (This.Sums, Data) = Good_Image then Found_Good
      else Found_Bad)
   with Global => null;

   procedure Take_Long
     (This    : in out Check;
      Data    : Long;
      Outcome : out Outcome_Kind)
   with
     Inline,
     Global => null,
     Post   =>
       Outcome = Outcome_Of (This'Old, Data)
       and then This =
         (case Outcome is
             when Under_Way =>
               (This'Old with delta
                  Position => This'Old.Position + 1,
                  Sums     => Next (This'Old.Sums, Data)),
             when Found_Good =>
               (New_Check with delta
                  Good_Passes => Incremented (This'Old.Good_Passes),
                  Bad_Passes  => This'Old.Bad_Passes),
             when Found_Bad =>
               (New_Check with delta
                  Good_Passes => This'Old.Good_Passes,
                  Bad_Passes  => Incremented (This'Old.Bad_Passes)));

end URVOS.ROM_Checks;
