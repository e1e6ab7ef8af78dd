--  SPDX-License-Identifier: Apache-2.0

--  The clock never runs backwards, never wraps round and stops at its last
--  tick, after 697 years (FRM-1 to FRM-3). Each release of a task is in the
--  next major frame, at its offset. This holds for every tick and every offset
--  of both nodes. Theorems.In_Step covers frames that are made longer or
--  shorter.

with URVOS.Frames; use URVOS.Frames;

package Theorems.Time with Pure, SPARK_Mode, Ghost is

   --  Each tick adds one, except at the last tick.
   procedure Clock_Advances (Now : Clock_Tick)
   with
     Global => null,
     Post   =>
       (if Now < Last_Tick then Advanced (Now) = Now + 1
        else Advanced (Now) = Now);

   --  A release is in the next major frame, at its offset.
   procedure Release_Is_In_Next_Frame (Now : Clock_Tick; Offset : Minor_Frame)
   with
     Global => null,
     Post   =>
       Next_Release (Now, Offset) > Now
       and then Next_Release (Now, Offset) - Now < 2 * Ticks_Per_Major_Frame
       and then
         (if Next_Release (Now, Offset) <= Last_Tick
          then Minor_Frame_Of (Next_Release (Now, Offset)) = Offset);

   --  All ticks of a major frame have the same next frame.
   procedure Frame_Has_One_Successor (Now : Clock_Tick)
   with
     Global => null,
     Pre    => Now < Last_Tick
       and then Minor_Frame_Of (Now) < Minor_Frame'Last,
     Post   => Next_Frame (Advanced (Now)) = Next_Frame (Now);

   --  At its limit the clock stops before the next frame begins, so no task is
   --  released again.
   procedure Nothing_Is_Released_After_The_Last_Tick (Offset : Minor_Frame)
   with
     Global => null,
     Post   =>
       Advanced (Last_Tick) = Last_Tick
       and then Next_Release (Last_Tick, Offset) > Last_Tick;

end Theorems.Time;
