--  SPDX-License-Identifier: Apache-2.0

--  The processor of a telemetry board, as its own task: its DUART's interrupt,
--  its main program, its timer (report, appendix A; LNK-1).
--
--  The board receives arrived characters before its timer advances, and a
--  character begins when the one before it ended, not when the task woke up: a
--  delayed task therefore loses no character and does not take its delay for
--  silence. It measures the time of answers (RTP-4).
--
--  This holds only up to Longest_Pause. After a longer pause the task cannot
--  know the age of its input, and the board's unsent data are useless. The
--  board then restarts, with nothing received and nothing to send, and the
--  input is discarded (SAF-4).

with Telemetry;
with Telemetry.Shared_Boards;
with URVOS; use URVOS;

generic
   Board : in out Telemetry.Shared_Boards.Shared_Board;
package Partitions.Telemetry_Processor is

   --  Power up: the board starts, and its task with it. Earlier input is
   --  ignored. The board allows for a line with that delay (LNK-11).
   procedure Switch_On (Line : Telemetry.Line_Delay);

   --  The reset switch: the board restarts at once.
   procedure Reset;

   --  The controller has given the board data: its main program, which polls
   --  its flags, finds them now.
   procedure Look;

   --  The number of restarts without a request.
   function Starts_Unasked return Count;

end Partitions.Telemetry_Processor;
