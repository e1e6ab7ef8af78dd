--  SPDX-License-Identifier: Apache-2.0

--  The partition's time: since the machine was started, and since the node
--  was switched on; and whether the node has stood still (SAF-4).

with Ada.Real_Time; use Ada.Real_Time;

with Host;
with Partitions.Measurements;
with Partitions.Octets;
with URVOS.Frames; use URVOS.Frames;

package Partitions.Clocks is

   --  The node is switched on now.
   procedure Switch_On;

   --  Waits until the next time that lies so many ticks after a whole major
   --  frame of the machine's clock.
   procedure Await_Phase (Ticks : Natural);

   function Switched_On_At return Time;

   --  Since the node was switched on.
   function Elapsed return Host.Microseconds;

   --  Frames that were shorter or longer (FRM-6) have moved tick 0 to there.
   procedure Count_From (At_Time : Time);

   --  When the node's clock should have shown this tick.
   function Time_Of (Now : Clock_Tick) return Time;

   --  A node whose clock has not been seen to tick for longer than this has
   --  stood still: what it was about to do is of another time.
   Longest_Pause : constant Time_Span := Milliseconds (100);

   --  The clock ticks now, or the tasks are loaded now.
   procedure See_Tick;

   --  Never before the clock was first seen.
   function Has_Stood_Still return Boolean;

   --  The clock has been seen: the cold start is over.
   function Is_Running return Boolean;

   --  Since the machine was: what two partitions of one machine share.
   function Machine_Time (At_Time : Time) return Host.Microseconds;

   --  Universal time, in us since 1970: what other programs go by, too.
   function UTC return Octets.Number;

   --  For distributions; 0 when negative.
   function Tenths_Of_Microseconds
     (Span : Time_Span) return Measurements.Measure;

end Partitions.Clocks;
