--  SPDX-License-Identifier: Apache-2.0

--  RECV with a wait (report, section 3.4; MBX-3, MBX-5).
--
--     Timeout := Begun (Now, 3);
--     --  In this step and, after EXIT, in those that follow:
--     Receive_Step (Now, Timeout, Command, Fresh, Look_Again);
--
--  Each step looks into a mailbox. While it holds nothing new, the task ends
--  the step with EXIT and looks again in the next step, until the wait is
--  over. The last look is a plain Receive: without a new message it gives the
--  old one and counts the miss. One RECV thus counts at most one miss, and a
--  wait of 0 ticks looks once.

with URVOS.Frames; use URVOS.Frames;
with URVOS.Shared_Mailboxes;
with URVOS.Waits;  use URVOS.Waits;

generic
   with package Messages is new URVOS.Shared_Mailboxes (<>);
   Variable : in out Messages.Variable;
package URVOS.Receive_Calls with SPARK_Mode is

   --  One look of a RECV whose wait has begun. Look_Again is False when the
   --  RECV has ended, with or without a fresh message. A RECV looks at most
   --  Ticks * 100,000 + 1 times, and 100,001 times if the clock has stopped.
   procedure Receive_Step
     (Now        : Clock_Tick;
      Timeout    : in out Wait;
      Item       : out Messages.Message;
      Fresh      : out Boolean;
      Look_Again : out Boolean)
   with
     Global => (In_Out => Variable),
     Post   =>
       (if Fresh then not Look_Again)
       and then
         (if Look_Again
          then Looks_Left (Timeout) < Looks_Left (Timeout'Old)
            and then Last_Seen (Timeout) >= Last_Seen (Timeout'Old)
          else Timeout = Timeout'Old);

end URVOS.Receive_Calls;
