--  SPDX-License-Identifier: Apache-2.0

--  The round trip time of the line, from the telemetry board's answers, and
--  whether they come in time (RTP-4, LNK-11).
--
--  A status answers each data message: after the line's round trip, the guard
--  time of the other board, and its own character. The measurement includes
--  the lateness of both machines, and is accurate to 0.1 ms.

with Ada.Real_Time; use Ada.Real_Time;

with Partitions.Measurements; use Partitions.Measurements;
with Telemetry;
with URVOS;                   use URVOS;

package Partitions.Round_Trips is

   --  The board's setting for the line, before it starts.
   procedure Set_Line (Line : Telemetry.Line_Delay);

   --  The longest round trip for which the board waits.
   function Longest return Time_Span;

   --  True if the board still waits for an answer this time after its last
   --  character.
   function Is_In_Time (After : Time_Span) return Boolean;

   --  The first character of an answer has arrived, this time after the last
   --  one of the data message.
   procedure Note_Answer (After : Time_Span);

   --  Round trips, in tenths of microseconds, and the number of answers after
   --  the board's time-out.
   function Measured return Statistics;
   function Late return Count;

   --  The number of answers.
   function Heard return Count;

   --  "0.3" milliseconds.
   function Image (Time : Measure) return String;

   --  News for people, or empty: the first second's round trip; that answers
   --  come too late, with the remedy; that they are in time again.
   function Next_Message (Now : String) return String;

end Partitions.Round_Trips;
