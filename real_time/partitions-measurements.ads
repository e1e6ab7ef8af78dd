--  SPDX-License-Identifier: Apache-2.0

--  The distribution of many measured durations or delays, in a fixed amount of
--  memory.

package Partitions.Measurements is

   --  Each value up to this one has its own count; larger ones share one.
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
