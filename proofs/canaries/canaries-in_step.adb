--  SPDX-License-Identifier: Apache-2.0

package body Canaries.In_Step with SPARK_Mode is

   procedure It_Is_Always_A_Tick_Before (Item : Situation) is null;

   procedure Ten_Ticks_Are_A_Frame
     (Clock   : Frame_Clock;
      Request : Frame_Request)
   is null;

end Canaries.In_Step;
