--  SPDX-License-Identifier: Apache-2.0

--  The processor of a telemetry board, as its own task: its DUART's
--  interrupt, its main program, its timer (report, appendix A; LNK-1).
--
--  What has arrived is told before the board is told that time has passed,
--  and a character begins when the one before it ended, not when the task
--  woke up: so a task that the machine runs late loses no character and
--  takes no lateness for silence. How long answers take it notes (RTP-4).
--
--  Only so late, though. A task that has not looked at its input for longer
--  than Longest_Pause cannot know how old it is, nor is what the board was
--  about to send of any use. Then the board starts anew, with nothing
--  received and nothing to send, and the input is thrown away (SAF-4).

with Telemetry;
with Telemetry.Shared_Boards;
with URVOS; use URVOS;

generic
   Board : in out Telemetry.Shared_Boards.Shared_Board;
package Partitions.Telemetry_Processor is

   --  Power up: the board starts, and its task with it. It hears nothing
   --  that came before. It waits for a line with that delay (LNK-11).
   procedure Switch_On (Line : Telemetry.Line_Delay);

   --  The reset switch: the board starts anew, at once.
   procedure Reset;

   --  The controller has given the board something: its main program, which
   --  looks at its flags all the time, finds it now.
   procedure Look;

   --  How often the board has started anew without having been told to.
   function Starts_Unasked return Count;

end Partitions.Telemetry_Processor;
