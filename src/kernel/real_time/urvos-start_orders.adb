--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Start_Orders with SPARK_Mode is

   procedure Look
     (State      : in out Node_State;
      Self       : Seat;
      Next_Order : out Order) is
   begin
      --  Almost every look.
      if State.Doing = Running and then not State.Is_Wanted then
         Next_Order := (Name => Carry_On, others => <>);
      else
         State := Heard (State);
         Next_Order := Order_For (State, Self);
         State := State_After (State, Self);
      end if;
   end Look;

end URVOS.Start_Orders;
