--  SPDX-License-Identifier: Apache-2.0

--  For a node that follows nobody: each frame lasts as long as ever (FRM-6).

with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;

procedure URVOS.Usual_Frames (Ticks : Tick_Count; Wish : out Frame_Wish)
with
  SPARK_Mode,
  Global => null,
  Post   => Wish = No_Wish;
