--  SPDX-License-Identifier: Apache-2.0

package body URVOS.ROM_Checks with SPARK_Mode is

   procedure Take_Long
     (This    : in out Check;
      Data    : Long;
      Outcome : out Outcome_Kind) is
   begin
      This.Sums := Next (This.Sums, Data);

      if This.Position < Last then
         This.Position := This.Position + 1;
         Outcome := Under_Way;
      else
         if This.Sums = Good_Image then
            This.Good_Passes := Incremented (This.Good_Passes);
            Outcome := Found_Good;
         else
            This.Bad_Passes := Incremented (This.Bad_Passes);
            Outcome := Found_Bad;
         end if;
         This.Position := 0;
         This.Sums := First_Value;
      end if;
   end Take_Long;

end URVOS.ROM_Checks;
