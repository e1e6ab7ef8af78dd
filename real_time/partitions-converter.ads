--  SPDX-License-Identifier: Apache-2.0

--  The hardware of an A/D board, as its own task: 16 us after a channel is
--  started its conversion is complete and the controller is interrupted.
--
--  A scan is 32 conversions, each started by the interrupt before it. They are
--  made together when the last of them is due, 512 us after the first was
--  started, from values held at the start. A scan that directly follows
--  another one begins when that one ended: on the target a few instructions
--  pass in between, here two threads take turns (D-42).
--
--  On the target the controller's processor takes the interrupt between two of
--  its instructions, and as soon as the conversion is over. Here another
--  thread takes it, which the machine may stop in between. A conversion's end
--  and its interrupt are therefore one step, and code that starts conversions
--  excludes it: otherwise a word of an abandoned scan would enter the next
--  scan, as the word of another channel (SAF-2).

with URV.AD_Boards;
with URV.Buffers; use URV.Buffers;

generic
   Board : in out URV.AD_Boards.Board;

   --  Samples the channels. Is_Next: the scan follows another of the same
   --  frame. Without Is_There no conversion of the scan ends (D-33).
   with procedure Sample
     (Is_Next  : Boolean;
      Words    : out Channel_Words;
      Is_There : out Boolean);
   with procedure Interrupt_Controller;
package Partitions.Converter is

   --  Between Hold and its release no conversion ends; after it the hardware
   --  looks for a start. The task and the start that begin scans never run at
   --  the same time.
   procedure Hold_Interrupts;
   procedure Release_Interrupts;

end Partitions.Converter;
