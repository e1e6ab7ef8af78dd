--  SPDX-License-Identifier: Apache-2.0

package body Devices.Shared_PWM_Board with SPARK_Mode is

   --  The words without a controller are computed only when they are needed.
   procedure Pass_Tick (State : in out Board_State)
   with
     Global => null,
     Post   => State = Ticked (State'Old, Unattended (State'Old.Words));

   procedure Pass_Tick (State : in out Board_State) is
   begin
      if Is_Left_Alone (State) then
         State := Ticked (State, Unattended (State.Words));
      else
         Count_Tick (State);
      end if;
   end Pass_Tick;

   protected body Board is

      procedure Write (Area : Data_Area) is
      begin
         State := Written (Area);
      end Write;

      procedure Touch is
      begin
         Devices.PWM_Board.Touch (State);
      end Touch;

      procedure Tick is
      begin
         Pass_Tick (State);
      end Tick;

      function Contents return Data_Area is (State.Words);

      procedure Look_For_Change (Changed : out Boolean) is
      begin
         Take_Change (State, Changed);
      end Look_For_Change;

      function Is_Unattended return Boolean is
        (State.Untouched = Hold_Ticks);

   end Board;

end Devices.Shared_PWM_Board;
