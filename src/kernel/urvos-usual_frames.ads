--  SPDX-License-Identifier: Apache-2.0

--  For a node that follows no other: each frame has the usual length (FRM-6).

with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;

procedure URVOS.Usual_Frames
  (Ticks : Tick_Count; Request : in out Frame_Request)
with
  SPARK_Mode,
  Global => null,
  Post   => Request = (Request'Old with delta Length => Usual_Length);
