--  SPDX-License-Identifier: Apache-2.0

--  A wait of some clock ticks (report, sections 3.4 and 3.5; MBX-3, MBX-5,
--  SEM-1, FRM-7): the time for which a task goes on looking.
--
--     Timeout := Begun (Now, 2);
--     while not Is_Over (Timeout, Now) loop
--        --  Look, call EXIT, read the clock.
--        Note_Look (Timeout, Now);
--     end loop;
--     --  Look for the last time.
--
--  Every wait ends, whatever the clock does. At the clock's last tick, where
--  time stops, a wait is over. A tick earlier than the last one seen is
--  ignored. A clock that has not moved for Most_Looks looks has stopped: a
--  look with its EXIT takes more than 20 ns, so a tick has fewer looks than
--  that.

with URVOS.Frames; use URVOS.Frames;

package URVOS.Waits with Pure, SPARK_Mode is

   --  The length of a wait, in ticks: one minute at most.
   Longest_Wait : constant := 60_000_000 / Microseconds_Per_Tick;
   type Wait_Ticks is range 0 .. Longest_Wait;

   --  The most looks while the clock does not move: one tick, 20 ns a look.
   Most_Looks : constant := Microseconds_Per_Tick * 50;

   type Look_Count is range 0 .. Longest_Wait * Most_Looks;

   type Wait is private;

   --  The ticks left of the wait, from the last tick seen.
   function Ticks_Left (This : Wait) return Wait_Ticks
   with Global => null;

   --  The latest tick seen.
   function Last_Seen (This : Wait) return Clock_Tick
   with Global => null;

   --  The number of looks since the clock moved.
   function Looks (This : Wait) return Look_Count
   with
     Global => null,
     Post   =>
       Looks'Result <= Most_Looks
       and then (if Ticks_Left (This) = 0 then Looks'Result = 0);

   --  The wait is over: its ticks have passed, or the clock has stopped.
   function Is_Over (This : Wait; Now : Clock_Tick) return Boolean is
     (Now = Last_Tick
      or else
        (if Now > Last_Seen (This)
         then Now - Last_Seen (This) >= Tick (Ticks_Left (This))
         else Ticks_Left (This) = 0 or else Looks (This) = Most_Looks))
   with Global => null;

   --  An upper limit of the remaining looks.
   function Looks_Left (This : Wait) return Look_Count is
     (Look_Count (Ticks_Left (This)) * Most_Looks - Looks (This))
   with Global => null;

   --  A wait that begins now. A wait of 0 ticks is over at once.
   function Begun (Now : Clock_Tick; Ticks : Wait_Ticks) return Wait
   with
     Global => null,
     Post   =>
       Ticks_Left (Begun'Result) = Ticks
       and then Last_Seen (Begun'Result) = Now
       and then Looks (Begun'Result) = 0;

   --  After is the wait Before, after one more look without success.
   function Is_A_Look_Later
     (Before, After : Wait;
      Now           : Clock_Tick) return Boolean
   is
     (if Now > Last_Seen (Before)
      then Last_Seen (After) = Now
        and then Tick (Ticks_Left (After)) =
          Tick (Ticks_Left (Before)) - (Now - Last_Seen (Before))
        and then Looks (After) = 1
      else Last_Seen (After) = Last_Seen (Before)
        and then Ticks_Left (After) = Ticks_Left (Before)
        and then Looks (After) = Looks (Before) + 1)
   with
     Global => null,
     Pre    => not Is_Over (Before, Now);

   --  Records a look without success at the time Now. Each look leaves fewer
   --  looks, so no wait is for ever (MBX-5).
   procedure Note_Look (This : in out Wait; Now : Clock_Tick)
   with
     Global => null,
     Pre    => not Is_Over (This, Now),
     Post   =>
       Is_A_Look_Later (This'Old, This, Now)
       and then Looks_Left (This) < Looks_Left (This'Old);

private

   type Wait is record
      Left : Wait_Ticks := 0;
      Seen : Clock_Tick := 0;
      Done : Look_Count := 0;
   end record
   with
     Predicate => Done <= Most_Looks and then (if Left = 0 then Done = 0);

   function Ticks_Left (This : Wait) return Wait_Ticks is (This.Left);

   function Last_Seen (This : Wait) return Clock_Tick is (This.Seen);

   function Looks (This : Wait) return Look_Count is (This.Done);

   function Begun (Now : Clock_Tick; Ticks : Wait_Ticks) return Wait is
     ((Left => Ticks, Seen => Now, Done => 0));

end URVOS.Waits;
