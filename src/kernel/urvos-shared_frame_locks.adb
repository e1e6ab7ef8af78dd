--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Shared_Frame_Locks with SPARK_Mode is

   protected body Lock is

      procedure Set (On : Boolean) is
      begin
         Is_On := On;
         State := At_Start;
      end Set;

      procedure Restart is
      begin
         State := Restarted (State);
      end Restart;

      procedure Tick (Available : Boolean) is
      begin
         if Is_On then
            Take_Tick (State, Available);
         end if;
      end Tick;

      procedure Take (Fresh : Boolean; Now : Clock_Tick) is
      begin
         if Is_On then
            State := Taken (State, Fresh, Frame_Of (Now));
         end if;
      end Take;

      function Is_In_Use return Boolean is (Is_On);

      function Request return Frame_Request is (State.Request);

      function Contents return Lock_State is (State);

   end Lock;

end URVOS.Shared_Frame_Locks;
