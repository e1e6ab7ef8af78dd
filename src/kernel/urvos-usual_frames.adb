--  SPDX-License-Identifier: Apache-2.0

procedure URVOS.Usual_Frames
  (Ticks : Tick_Count; Request : in out Frame_Request)
with SPARK_Mode
is
   pragma Unreferenced (Ticks);
begin
   Request.Length := Usual_Length;
end URVOS.Usual_Frames;
