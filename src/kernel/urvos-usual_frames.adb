--  SPDX-License-Identifier: Apache-2.0

procedure URVOS.Usual_Frames (Ticks : Tick_Count; Wish : out Frame_Wish)
with SPARK_Mode
is
   pragma Unreferenced (Ticks);
begin
   Wish := No_Wish;
end URVOS.Usual_Frames;
