--  SPDX-License-Identifier: Apache-2.0

package body Devices.PWM_Board with SPARK_Mode is

   procedure Count_Tick (This : in out Board_State) is
   begin
      This.Untouched := This.Untouched + 1;
   end Count_Tick;

end Devices.PWM_Board;
