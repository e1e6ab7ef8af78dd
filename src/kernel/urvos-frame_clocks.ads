--  SPDX-License-Identifier: Apache-2.0

--  A clock whose major frames may be a tick shorter or longer (FRM-6).
--
--  The last minor frame of a major frame, in which no task is released,
--  lasts no tick of the oscillator, one or two. All others last one. So for
--  the kernel and the tasks a major frame still has ten minor frames, each
--  release comes once, and only how long the last minor frame lasts changes.

with URVOS.Frames; use URVOS.Frames;

package URVOS.Frame_Clocks with Pure, SPARK_Mode is

   --  In ticks of the oscillator.
   type Frame_Length is range
     Ticks_Per_Major_Frame - 1 .. Ticks_Per_Major_Frame + 1;

   Usual_Length : constant Frame_Length := Ticks_Per_Major_Frame;

   --  What somebody wants: that the frame that begins with this tick lasts
   --  so long. Others last as long as ever.
   type Frame_Request is record
      Frame  : Clock_Tick   := 0;
      Length : Frame_Length := Usual_Length;
   end record;

   No_Request : constant Frame_Request := (others => <>);

   --  Since somebody last looked.
   subtype Tick_Count is Natural range 0 .. 1;

   type Frame_Clock is record
      Now  : Clock_Tick := 0;

      --  The last minor frame lasts for its second tick.
      Held : Boolean    := False;
   end record;

   --  The tick with which the present major frame began.
   function Frame_Of (Now : Clock_Tick) return Clock_Tick is
     (Now - Now mod Ticks_Per_Major_Frame)
   with Global => null;

   --  How long the present frame is to last.
   function Length_Of
     (Now     : Clock_Tick;
      Request : Frame_Request) return Frame_Length
   is
     (if Request.Frame = Frame_Of (Now) then Request.Length else Usual_Length)
   with Global => null;

   --  The clock after one more tick of the oscillator.
   function Ticked
     (Clock   : Frame_Clock;
      Request : Frame_Request) return Frame_Clock
   is
     (if Minor_Frame_Of (Clock.Now) = Minor_Frame'Last - 1
        and then Length_Of (Clock.Now, Request) < Usual_Length
      then (Advanced (Advanced (Clock.Now)), Held => False)
      elsif Minor_Frame_Of (Clock.Now) = Minor_Frame'Last
        and then Length_Of (Clock.Now, Request) > Usual_Length
        and then not Clock.Held
      then (Clock.Now, Held => True)
      else (Advanced (Clock.Now), Held => False))
   with Global => null;

end URVOS.Frame_Clocks;
