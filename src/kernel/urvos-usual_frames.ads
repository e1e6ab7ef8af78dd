--  SPDX-License-Identifier: Apache-2.0

--  For a node that follows nobody: each frame lasts as long as ever (FRM-6).

with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;

procedure URVOS.Usual_Frames (Ticks : Tick_Count; Request : out Frame_Request)
with
  SPARK_Mode,
  Global => null,
  Post   => Request = No_Request;
