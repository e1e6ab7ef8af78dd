--  SPDX-License-Identifier: Apache-2.0

--  A clock whose major frames may be a tick shorter or longer (FRM-6).
--
--  No task is released in the last minor frame of a major frame. This minor
--  frame lasts zero, one or two ticks of the oscillator; all others last one.
--  For the kernel and the tasks each major frame still has ten minor frames,
--  and each release comes once. Only the duration of the last minor frame
--  changes.

with URVOS.Frames; use URVOS.Frames;

package URVOS.Frame_Clocks with Pure, SPARK_Mode is

   --  In ticks of the oscillator.
   type Frame_Length is range
     Ticks_Per_Major_Frame - 1 .. Ticks_Per_Major_Frame + 1;

   Usual_Length : constant Frame_Length := Ticks_Per_Major_Frame;

   --  A request that the frame that begins with tick Frame has this length.
   --  All other frames have the usual length.
   type Frame_Request is record
      Frame  : Clock_Tick   := 0;
      Length : Frame_Length := Usual_Length;
   end record;

   No_Request : constant Frame_Request := (others => <>);

   --  The number of ticks since the last look.
   subtype Tick_Count is Natural range 0 .. 1;

   type Frame_Clock is record
      Now  : Clock_Tick := 0;

      --  The last minor frame is in its second tick.
      Held : Boolean    := False;
   end record;

   --  The tick with which the present major frame began.
   function Frame_Of (Now : Clock_Tick) return Clock_Tick is
     (Now - Now mod Ticks_Per_Major_Frame)
   with Global => null;

   --  The length of the present frame.
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

   --  The same in place. A frame of the usual length needs no division.
   procedure Take_Tick (Clock : in out Frame_Clock; Request : Frame_Request)
   with
     Inline,
     Global => null,
     Post   => Clock = Ticked (Clock'Old, Request);

end URVOS.Frame_Clocks;
