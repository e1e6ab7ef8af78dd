--  RECV with a wait (report, section 3.4; MBX-3, MBX-5).
--
--     Receive_Within (3, Command, Fresh);
--
--  Looks into a mailbox; while nothing new is there it calls EXIT and looks
--  again, until the wait is over. The last look is a plain Receive: if it
--  is in vain it gives the old message and counts the miss. So there is one
--  miss, however often it looked, and a wait of 0 ticks looks once.
--
--  A task that is run in steps calls Receive_Step once in a step and ends
--  the step with EXIT while it is told to look again.

with URVOS.Frames; use URVOS.Frames;
with URVOS.Waits;  use URVOS.Waits;

generic
   type Message is private;

   --  Those of the mailbox. Look counts no miss.
   with procedure Look (Item : out Message; Fresh : out Boolean);
   with procedure Receive (Item : out Message; Fresh : out Boolean);

   with procedure Read_Clock (Now : out Clock_Tick);
package URVOS.Receive_Calls with SPARK_Mode is

   --  One look of a RECV whose wait has begun. Look_Again is False when the
   --  RECV has ended, with a fresh message or without.
   procedure Receive_Step
     (Patience   : in out Wait;
      Item       : out Message;
      Fresh      : out Boolean;
      Look_Again : out Boolean)
   with
     Post =>
       (if Fresh then not Look_Again)
       and then
         (if Look_Again
          then Looks_Left (Patience) < Looks_Left (Patience'Old)
            and then Last_Seen (Patience) >= Last_Seen (Patience'Old)
          else Patience = Patience'Old);

   --  RECV, as a whole. It looks Ticks * 100,000 + 1 times at most; when
   --  the clock stands still, 100,001 times.
   generic
      with procedure Exit_Processor;
   procedure Receive_Within
     (Ticks : Wait_Ticks;
      Item  : out Message;
      Fresh : out Boolean);

end URVOS.Receive_Calls;
