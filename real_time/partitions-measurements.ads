--  SPDX-License-Identifier: Apache-2.0

--  How long something took, how late it was: the distribution of many
--  measurements, in fixed room.

package Partitions.Measurements is

   --  Up to here each value is counted apart; a larger one only as larger.
   Finest : constant := 60_000;

   type Measure is range 0 .. 2 ** 62;
   subtype Total is Measure;

   type Bin is range 0 .. Finest;
   type Bin_Count is range 0 .. 2 ** 31 - 1;
   type Bin_Counts is array (Bin) of Bin_Count;

   type Statistics is record
      Number  : Total   := 0;
      Minimum : Measure := 0;
      Median  : Measure := 0;
      P99     : Measure := 0;
      Maximum : Measure := 0;
   end record;

   protected type Distribution is

      procedure Add (Value : Measure);

      function Summed_Up return Statistics;

   private
      Counts  : Bin_Counts := (others => 0);
      Number  : Total      := 0;
      Minimum : Measure    := Measure'Last;
      Maximum : Measure    := 0;
   end Distribution;

end Partitions.Measurements;
