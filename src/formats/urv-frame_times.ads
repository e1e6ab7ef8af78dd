--  SPDX-License-Identifier: Apache-2.0

--  Times as numbers of major frames (FRM-7, D-75).
--
--  The kernel defines the length of a frame. The flight software declares its
--  times in seconds and its rates per second. The factors below convert them
--  to frames:
--
--     Hold_After : constant := 5 * Frames_Per_Tenth;
--     Roll_Step  : constant := Roll_Rate_Limit / Frames_Per_Second;

with URVOS.Frames; use URVOS.Frames;

package URV.Frame_Times with Pure, SPARK_Mode is

   Microseconds_Per_Frame : constant :=
     Ticks_Per_Major_Frame * Microseconds_Per_Tick;

   Frames_Per_Second : constant := 1_000_000 / Microseconds_Per_Frame;
   Frames_Per_Tenth  : constant := Frames_Per_Second / 10;

   pragma Compile_Time_Error
     (10 * Frames_Per_Tenth * Microseconds_Per_Frame /= 1_000_000,
      "a tenth of a second must be a whole number of major frames");

end URV.Frame_Times;
