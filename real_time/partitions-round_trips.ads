--  SPDX-License-Identifier: Apache-2.0

--  How long the line takes there and back, as the telemetry board's answers
--  show, and whether they come in time (RTP-4, LNK-11).
--
--  A status answers each data message: after the line's round trip, the guard
--  time of the other board, and its own character. What is measured has the
--  lateness of both machines in it, and is accurate to 0.1 ms.

with Ada.Real_Time; use Ada.Real_Time;

with Partitions.Measurements; use Partitions.Measurements;
with Telemetry;
with URVOS;                   use URVOS;

package Partitions.Round_Trips is

   --  What the board has been told of the line, before it starts.
   procedure Set_Line (Line : Telemetry.Line_Delay);

   --  The longest round trip for which the board waits.
   function Longest return Time_Span;

   --  The board still waits for an answer so long after its last character.
   function Is_In_Time (After : Time_Span) return Boolean;

   --  The first character of an answer has come, so long after the last one
   --  of the data message had left.
   procedure Note_Answer (After : Time_Span);

   --  Round trips, in tenths of microseconds, and how many answers came when
   --  the board had given up.
   function Measured return Statistics;
   function Late return Count;

   --  How many answers came at all.
   function Heard return Count;

   --  "0.3" milliseconds.
   function Image (Time : Measure) return String;

   --  What is new, for people, or nothing: the first second's round trip,
   --  that answers come too late and what to do about it, and that they are
   --  in time again.
   function Next_News (Now : String) return String;

end Partitions.Round_Trips;
