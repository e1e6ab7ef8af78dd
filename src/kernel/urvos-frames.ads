--  Time as the operating system counts it (report, section 2.2; FRM-1 to
--  FRM-3).
--
--  One clock tick is one minor frame of 2 ms. Ten minor frames make a major
--  frame of 20 ms, the period of every task.
--
--  The clock counts to Last_Tick and then stands still: it never wraps
--  round, so no task is ever released early. That is after 697 years; all
--  boards then keep what they were last given.

package URVOS.Frames with Pure, SPARK_Mode is

   Microseconds_Per_Tick : constant := 2_000;

   Ticks_Per_Major_Frame : constant := 10;

   --  The tick that a task sleeps until. It may lie within the major frame
   --  that follows the clock's last one.
   type Tick is range 0 .. 10 * 2 ** 40 + 9;

   Last_Tick : constant Tick := 10 * 2 ** 40 - 1;

   --  What the clock shows.
   subtype Clock_Tick is Tick range 0 .. Last_Tick;

   --  A place within a major frame: a task's release offset (FRM-2).
   type Minor_Frame is range 0 .. Ticks_Per_Major_Frame - 1;

   --  The clock after one more tick. At its last tick it stands still.
   function Advanced (Now : Clock_Tick) return Clock_Tick is
     (if Now = Last_Tick then Last_Tick else Now + 1)
   with Global => null;

   function Minor_Frame_Of (Now : Clock_Tick) return Minor_Frame is
     (Minor_Frame (Now mod Ticks_Per_Major_Frame))
   with Global => null;

   --  The tick at which the next major frame begins: the one place where
   --  tasks get it from (FRM-3).
   function Next_Frame (Now : Clock_Tick) return Tick is
     (Now - Now mod Ticks_Per_Major_Frame + Ticks_Per_Major_Frame)
   with
     Global => null,
     Post   =>
       --  It begins a major frame, later than now and at most one frame
       --  away.
       Next_Frame'Result mod Ticks_Per_Major_Frame = 0
       and then Next_Frame'Result > Now
       and then Next_Frame'Result - Now <= Ticks_Per_Major_Frame
       and then Next_Frame'Result <= Last_Tick + 1;

   --  A task's next release: its offset within the next major frame.
   function Next_Release
     (Now    : Clock_Tick;
      Offset : Minor_Frame) return Tick
   is (Next_Frame (Now) + Tick (Offset))
   with Global => null;

end URVOS.Frames;
