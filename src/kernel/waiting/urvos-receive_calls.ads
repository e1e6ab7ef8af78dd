--  SPDX-License-Identifier: Apache-2.0

--  RECV with a wait (report, section 3.4; MBX-3, MBX-5).
--
--     Patience := Begun (Now, 3);
--     --  In this step and, after EXIT, in those that follow:
--     Receive_Step (Now, Patience, Command, Fresh, Look_Again);
--
--  Each step looks into a mailbox; while nothing new is there the task ends
--  the step with EXIT and looks again in the next, until the wait is over.
--  The last look is a plain Receive: if it is in vain it gives the old
--  message and counts the miss. So there is one miss, however often it
--  looked, and a wait of 0 ticks looks once.

with URVOS.Frames; use URVOS.Frames;
with URVOS.Shared_Mailboxes;
with URVOS.Waits;  use URVOS.Waits;

generic
   with package Messages is new URVOS.Shared_Mailboxes (<>);
   Variable : in out Messages.Variable;
package URVOS.Receive_Calls with SPARK_Mode is

   --  One look of a RECV whose wait has begun. Look_Again is False when the
   --  RECV has ended, with a fresh message or without. It looks Ticks *
   --  100,000 + 1 times at most; when the clock stands still, 100,001 times.
   procedure Receive_Step
     (Now        : Clock_Tick;
      Patience   : in out Wait;
      Item       : out Messages.Message;
      Fresh      : out Boolean;
      Look_Again : out Boolean)
   with
     Global => (In_Out => Variable),
     Post   =>
       (if Fresh then not Look_Again)
       and then
         (if Look_Again
          then Looks_Left (Patience) < Looks_Left (Patience'Old)
            and then Last_Seen (Patience) >= Last_Seen (Patience'Old)
          else Patience = Patience'Old);

end URVOS.Receive_Calls;
