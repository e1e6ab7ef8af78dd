--  SPDX-License-Identifier: Apache-2.0

package body Devices.Shared_PWM_Board with SPARK_Mode is

   protected body Board is

      procedure Write (Area : Data_Area) is
      begin
         State := Written (Area);
      end Write;

      procedure Touch is
      begin
         State := Touched (State);
      end Touch;

      procedure Tick is
      begin
         State := Ticked (State, Unattended (State.Words));
      end Tick;

      function Contents return Data_Area is (State.Words);

      function Is_Unattended return Boolean is
        (State.Untouched = Hold_Ticks);

   end Board;

end Devices.Shared_PWM_Board;
