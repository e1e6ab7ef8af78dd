--  SPDX-License-Identifier: Apache-2.0

package body Devices.PWM_Board with SPARK_Mode is

   procedure Touch (This : in out Board_State) is
   begin
      This.Untouched := 0;
   end Touch;

   procedure Count_Tick (This : in out Board_State) is
   begin
      This.Untouched := This.Untouched + 1;
   end Count_Tick;

   procedure Take_Change (This : in out Board_State; Changed : out Boolean) is
   begin
      Changed := This.Changed;
      This.Changed := False;
   end Take_Change;

end Devices.PWM_Board;
