--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Start_Orders with SPARK_Mode is

   procedure Look
     (State      : in out Node_State;
      Self       : Seat;
      Next_Order : out Order) is
   begin
      State := Heard (State);
      Next_Order := Order_For (State, Self);
      State := State_After (State, Self);
   end Look;

end URVOS.Start_Orders;
