--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Frame_Clocks with SPARK_Mode is

   --  A tick of a frame of another length. It is out of line: it needs more
   --  registers than the usual tick.
   procedure Take_Requested_Tick
     (Clock : in out Frame_Clock; Request : Frame_Request)
   with
     No_Inline,
     Global => null,
     Post   => Clock = Ticked (Clock'Old, Request);

   procedure Take_Requested_Tick
     (Clock : in out Frame_Clock; Request : Frame_Request) is
   begin
      Clock := Ticked (Clock, Request);
   end Take_Requested_Tick;

   procedure Take_Tick (Clock : in out Frame_Clock; Request : Frame_Request) is
   begin
      if Request.Length = Usual_Length then
         Clock.Now := Advanced (Clock.Now);
         Clock.Held := False;
      else
         Take_Requested_Tick (Clock, Request);
      end if;
   end Take_Tick;

end URVOS.Frame_Clocks;
