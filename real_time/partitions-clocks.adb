--  SPDX-License-Identifier: Apache-2.0

with Partitions.System_Calls;

package body Partitions.Clocks is

   Tick_Time : constant Time_Span := Microseconds (Microseconds_Per_Tick);

   Ticks_Per_Second : constant := 1_000_000 / Microseconds_Per_Tick;

   use type Host.Microseconds;

   Beginning : Time := Clock;

   --  Set by the kernel's clock, read by the tasks.
   protected Last_Tick is
      procedure See (At_Time : Time);
      function Seen return Time;
      procedure Count_From (At_Time : Time);
      function Counted_From return Time;
   private
      Seen_At : Time := Time_First;
      From    : Time := Time_First;
   end Last_Tick;

   protected body Last_Tick is

      procedure See (At_Time : Time) is
      begin
         Seen_At := At_Time;
      end See;

      function Seen return Time is (Seen_At);

      procedure Count_From (At_Time : Time) is
      begin
         From := At_Time;
      end Count_From;

      function Counted_From return Time is (From);

   end Last_Tick;

   --  The factors are real numbers: a product with a whole one is a Duration,
   --  which has room for a second's microseconds of 2.5 h only.

   function In_Microseconds (Span : Time_Span) return Host.Microseconds is
     (Host.Microseconds (To_Duration (Span) * 1.0E6));

   procedure Switch_On is
   begin
      Beginning := Clock;
      Last_Tick.Count_From (Beginning);
   end Switch_On;

   procedure Count_From (At_Time : Time) is
   begin
      Last_Tick.Count_From (At_Time);
   end Count_From;

   procedure Await_Phase (Ticks : Natural) is
      Now  : constant Time := Clock;
      Past : constant Host.Microseconds :=
        Machine_Time (Now) mod Host.Major_Frame;
   begin
      delay until Now
        + Microseconds
            (Integer
               (2 * Host.Major_Frame - Past
                + Host.Microseconds (Ticks) * Host.Tick_Time));
   end Await_Phase;

   function Switched_On_At return Time is (Beginning);

   function Elapsed return Host.Microseconds is
     (In_Microseconds (Clock - Beginning));

   function Time_Of (Now : Clock_Tick) return Time is
     (Last_Tick.Counted_From
      + Seconds (Integer (Now / Ticks_Per_Second))
      + Integer (Now mod Ticks_Per_Second) * Tick_Time);

   procedure See_Tick is
   begin
      Last_Tick.See (Clock);
   end See_Tick;

   function Has_Stood_Still return Boolean is
      Seen : constant Time := Last_Tick.Seen;
   begin
      return Seen /= Time_First and then Clock - Seen > Longest_Pause;
   end Has_Stood_Still;

   function Is_Running return Boolean is (Last_Tick.Seen /= Time_First);

   function Machine_Time (At_Time : Time) return Host.Microseconds is
      Seconds : Seconds_Count;
      Rest    : Time_Span;
   begin
      Split (At_Time, Seconds, Rest);
      return Host.Microseconds (Seconds) * 1_000_000 + In_Microseconds (Rest);
   end Machine_Time;

   function UTC return Octets.Number is
      use type Octets.Number;

      Now    : System_Calls.Time_Span;
      Result : constant Integer :=
        Integer
          (System_Calls.Read_Clock (System_Calls.Universal_Time, Now));
      pragma Unreferenced (Result);
   begin
      return Octets.Number (Now.Seconds) * 1_000_000
        + Octets.Number (Now.Nanoseconds) / 1_000;
   end UTC;

   function Tenths_Of_Microseconds
     (Span : Time_Span) return Measurements.Measure
   is
     (if Span <= Time_Span_Zero then 0
      else Measurements.Measure (To_Duration (Span) * 1.0E7));

end Partitions.Clocks;
