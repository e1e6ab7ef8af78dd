--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Measurements is

   protected body Distribution is

      procedure Add (Value : Measure) is
         Place : constant Bin := Bin (Measure'Min (Value, Finest));
      begin
         Counts (Place) := Counts (Place) + 1;
         Number  := Number + 1;
         Minimum := Measure'Min (Minimum, Value);
         Maximum := Measure'Max (Maximum, Value);
      end Add;

      function Summed_Up return Statistics is

         --  The smallest value with at least this number of values up to it.
         function Quantile (Wanted : Total) return Measure;

         function Quantile (Wanted : Total) return Measure is
            Passed : Total := 0;
         begin
            for Place in Bin loop
               Passed := Passed + Total (Counts (Place));
               if Passed >= Wanted then
                  return Measure'Min (Measure (Place), Maximum);
               end if;
            end loop;
            return Maximum;
         end Quantile;
      begin
         return
           (if Number = 0 then (others => <>)
            else
              (Number  => Number,
               Minimum => Minimum,
               Median  => Quantile ((Number + 1) / 2),
               P99     => Quantile ((Number * 99 + 99) / 100),
               Maximum => Maximum));
      end Summed_Up;

   end Distribution;

end Partitions.Measurements;
