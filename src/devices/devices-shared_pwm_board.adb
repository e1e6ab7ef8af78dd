--  SPDX-License-Identifier: Apache-2.0

package body Devices.Shared_PWM_Board with SPARK_Mode is

   protected body Board is

      procedure Write (Area : Data_Area) is
      begin
         State := Written (Area);
         Is_New := True;
      end Write;

      procedure Touch is
      begin
         State.Untouched := 0;
      end Touch;

      procedure Tick is
      begin
         if Is_Left_Alone (State) then
            State := Ticked (State, Unattended (State.Words));
            Is_New := True;
         else
            Count_Tick (State);
         end if;
      end Tick;

      function Contents return Data_Area is (State.Words);

      procedure Look_For_Change (Changed : out Boolean) is
      begin
         Changed := Is_New;
         Is_New := False;
      end Look_For_Change;

      function Is_Unattended return Boolean is
        (State.Untouched = Hold_Ticks);

   end Board;

end Devices.Shared_PWM_Board;
