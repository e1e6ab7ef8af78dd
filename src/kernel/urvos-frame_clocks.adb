--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Frame_Clocks with SPARK_Mode is

   procedure Take_Tick (Clock : in out Frame_Clock; Request : Frame_Request) is
   begin
      if Request.Length = Usual_Length then
         Clock := (Advanced (Clock.Now), Held => False);
      else
         Clock := Ticked (Clock, Request);
      end if;
   end Take_Tick;

end URVOS.Frame_Clocks;
