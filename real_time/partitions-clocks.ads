--  SPDX-License-Identifier: Apache-2.0

--  The partition's time: since the machine was started, and since the node was
--  switched on, for weeks (RTP-1); and whether the node has stopped for a
--  while (SAF-4).

with Ada.Real_Time; use Ada.Real_Time;

with Host;
with Partitions.Measurements;
with Partitions.Octets;
with URVOS.Frames; use URVOS.Frames;

package Partitions.Clocks is

   --  The node is switched on now.
   procedure Switch_On;

   --  Waits until the next time that is this number of ticks after a whole
   --  major frame of the machine's clock.
   procedure Await_Phase (Ticks : Natural);

   function Switched_On_At return Time;

   function In_Microseconds (Span : Time_Span) return Host.Microseconds
   with Pre => Span >= Time_Span_Zero;

   --  Since the node was switched on.
   function Elapsed return Host.Microseconds;

   --  Shorter or longer frames (FRM-6) have moved tick 0 to this time.
   procedure Count_From (At_Time : Time);

   --  The nominal time of this tick of the node's clock.
   function Time_Of (Now : Clock_Tick) return Time;

   --  A node whose clock has not ticked for longer than this was stopped: its
   --  unfinished work belongs to another time.
   Longest_Pause : constant Time_Span := Milliseconds (100);

   --  The clock ticks now, or the tasks are loaded now.
   procedure See_Tick;

   --  Always False before the clock was first seen.
   function Has_Stood_Still return Boolean;

   --  The clock has been seen: the cold start is over.
   function Is_Running return Boolean;

   --  Since the machine was started: common to two partitions of one machine.
   function Machine_Time (At_Time : Time) return Host.Microseconds;

   --  Universal time, in us since 1970: common to other programs, too.
   function UTC return Octets.Number;

   --  For distributions; 0 when negative.
   function Tenths_Of_Microseconds
     (Span : Time_Span) return Measurements.Measure;

end Partitions.Clocks;
