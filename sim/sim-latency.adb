--  SPDX-License-Identifier: Apache-2.0

package body Sim.Latency is

   --  Drops the oldest change.
   procedure Drop_First (From : in out Collector);

   --  Drops the changes that have waited too long.
   procedure Expire (From : in out Collector; Time : Microseconds);

   --  Counts one latency.
   procedure Add (To : in out Collector; Measured : Microseconds);

   procedure Drop_First (From : in out Collector) is
   begin
      From.First   := From.First + 1;
      From.Pending := From.Pending - 1;
   end Drop_First;

   procedure Expire (From : in out Collector; Time : Microseconds) is
   begin
      while From.Pending > 0
        and then Time - From.Waiting (From.First).Time > Longest
      loop
         Drop_First (From);
         From.Totals.Expired := Incremented (From.Totals.Expired);
      end loop;
   end Expire;

   procedure Add (To : in out Collector; Measured : Microseconds) is
      Totals : Statistics renames To.Totals;
   begin
      if To.Counts = null then
         To.Counts      := new Histogram'(others => 0);
         Totals.Minimum := Measured;
      end if;
      To.Counts (Measured) := Incremented (To.Counts (Measured));
      Totals.Measured := Incremented (Totals.Measured);
      Totals.Minimum  := Microseconds'Min (Totals.Minimum, Measured);
      Totals.Maximum  := Microseconds'Max (Totals.Maximum, Measured);
   end Add;

   procedure Console_Changed
     (Into     : in out Collector;
      Time     : Microseconds;
      Expected : PWM_Buffer) is
   begin
      if Into.Has_Expected and then Into.Last_Expected = Expected then
         return;
      end if;
      Into.Has_Expected := True;
      Into.Last_Expected     := Expected;

      Expire (Into, Time);
      if Into.Pending = 0
        and then Into.Is_Set and then Into.Set = Expected
      then
         return;
      end if;

      if Into.Pending = Place'Modulus then
         Drop_First (Into);
         Into.Totals.Overtaken := Incremented (Into.Totals.Overtaken);
      end if;
      Into.Waiting (Into.First + Place'Mod (Into.Pending)) :=
        (Time, Expected);
      Into.Pending := Into.Pending + 1;
   end Console_Changed;

   procedure PWM_Written
     (Into    : in out Collector;
      Time    : Microseconds;
      Written : PWM_Buffer) is
   begin
      if Into.Is_Set and then Into.Set = Written then
         return;
      end if;
      Into.Is_Set := True;
      Into.Set    := Written;

      Expire (Into, Time);
      for Older in 0 .. Into.Pending - 1 loop
         declare
            Oldest : constant Change :=
              Into.Waiting (Into.First + Place'Mod (Older));
         begin
            if Oldest.Expected = Written then
               for Dropped in 1 .. Older loop
                  Drop_First (Into);
                  Into.Totals.Overtaken :=
                    Incremented (Into.Totals.Overtaken);
               end loop;
               Drop_First (Into);
               Add (Into, Time - Oldest.Time);
               return;
            end if;
         end;
      end loop;
   end PWM_Written;

   function Result (From : Collector) return Statistics is

      --  The smallest latency that at least Rank others do not exceed.
      function Ranked (Rank : Count) return Microseconds;

      function Ranked (Rank : Count) return Microseconds is
         Passed : Count := 0;
      begin
         for Value in From.Totals.Minimum .. From.Totals.Maximum loop
            Passed := Passed + From.Counts (Value);
            if Passed >= Rank then
               return Value;
            end if;
         end loop;
         return From.Totals.Maximum;
      end Ranked;

      Total : constant Count := From.Totals.Measured;
      Made  : Statistics     := From.Totals;
   begin
      if Total > 0 then
         --  Rounded up, without overflow of a count.
         Made.Median := Ranked (Total - Total / 2);
         Made.P99    := Ranked (Total - Total / 100);
      end if;
      return Made;
   end Result;

end Sim.Latency;
