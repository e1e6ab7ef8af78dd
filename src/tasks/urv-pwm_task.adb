--  SPDX-License-Identifier: Apache-2.0

with URV.Allocation;
with URV.Buffers; use URV.Buffers;
with URV.Errors;  use URV.Errors;
with URV.PWM_Layout;
with URV.Routing;

package body URV.PWM_Task with SPARK_Mode is

   procedure Run_Transaction is
      Health : constant Allocation.Health := Surface_Health.Contents;
      Item   : Uplink_Buffer;
      Fresh  : Boolean;
   begin
      PWM_Variable.Receive (Item, Fresh);
      PWM_Board.Touch;

      if not Fresh then
         Errors.Report (No_Commands, 0);
      elsif not Routing.Is_Old (Item) then
         PWM_Board.Write
           (PWM_Layout.To_Data_Area (Allocation.Servos (Item, Health)));
      end if;
   end Run_Transaction;

end URV.PWM_Task;
