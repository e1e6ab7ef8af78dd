--  SPDX-License-Identifier: Apache-2.0

--  The latency from a change at the pilot's console to the corresponding words
--  at the PWM board.
--
--  The latency of a change ends with the first write to the board that changes
--  its words into those the change requests. A change that a later one
--  overtook, because no frame sampled it, is dropped when that later one
--  arrives. A change without effect for two seconds is dropped, too. Times are
--  exact to the microsecond, and so are the percentiles: every latency is
--  counted by its value.

with URV.Buffers; use URV.Buffers;
with URVOS;       use URVOS;

package Sim.Latency is

   --  No change waits longer.
   Longest : constant Microseconds := 2_000_000;

   type Collector is limited private;

   --  The console's words changed; the PWM board should come to hold these. A
   --  change without a new request, such as a small change of a switch word,
   --  is not measured.
   procedure Console_Changed
     (Into     : in out Collector;
      Time     : Microseconds;
      Expected : PWM_Buffer);

   --  The PWM board was written.
   procedure PWM_Written
     (Into    : in out Collector;
      Time    : Microseconds;
      Written : PWM_Buffer);

   --  Statistics of the latencies so far. The median and the 99th percentile
   --  are latencies that occurred: the smallest that half, or 99 of 100, do
   --  not exceed. All are 0 when nothing was measured.
   type Statistics is record
      Measured  : Count        := 0;
      Overtaken : Count        := 0;
      Expired   : Count        := 0;
      Minimum   : Microseconds := 0;
      Median    : Microseconds := 0;
      P99       : Microseconds := 0;
      Maximum   : Microseconds := 0;
   end record;

   function Result (From : Collector) return Statistics;

private

   type Change is record
      Time     : Microseconds;
      Expected : PWM_Buffer;
   end record;

   --  Room for two seconds of a change every millisecond. When more wait, the
   --  oldest is dropped as overtaken.
   type Place is mod 2 ** 11;
   type Change_Ring is array (Place) of Change;

   type Histogram is array (Microseconds range 0 .. Longest) of Count;
   type Histogram_Access is access Histogram;

   type Collector is limited record
      --  The changes that wait, from First on.
      Waiting : Change_Ring;
      First   : Place := 0;
      Pending : Natural range 0 .. Place'Modulus := 0;

      --  The console's last request and the board's words.
      Has_Expected  : Boolean := False;
      Last_Expected : PWM_Buffer;
      Is_Set        : Boolean := False;
      Set           : PWM_Buffer;

      --  The number of occurrences of each latency. Too large for a stack;
      --  allocated at the first measurement.
      Counts : Histogram_Access;
      Totals : Statistics;
   end record;

end Sim.Latency;
