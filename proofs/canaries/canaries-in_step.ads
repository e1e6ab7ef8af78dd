--  SPDX-License-Identifier: Apache-2.0

--  Claims about frames in step that exceed the true bound by one.

with Theorems.In_Step;   use Theorems.In_Step;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;

package Canaries.In_Step with Pure, SPARK_Mode, Ghost is

   --  False: clocks drift apart before the lock answers.
   procedure It_Is_Always_A_Tick_Before (Item : Situation)
   with
     Global => null,
     Pre    => Is_In_Step (Item),
     Post   => Item.Before >= Tick_Time;  --  VC_POSTCONDITION

   --  False: a request in the last tick of a frame still has effect.
   procedure Ten_Ticks_Are_A_Frame
     (Clock   : Frame_Clock;
      Request : Frame_Request)
   with
     Global => null,
     Pre    => Clock.Now < Last_Tick,
     Post   =>
       Ticked (Clock, Request).Now = Clock.Now + 1;  --  VC_POSTCONDITION

end Canaries.In_Step;
