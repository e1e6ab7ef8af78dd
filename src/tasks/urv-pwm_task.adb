--  SPDX-License-Identifier: Apache-2.0

with URV.Allocation;  use URV.Allocation;
with URV.Buffers;     use URV.Buffers;
with URV.Errors;      use URV.Errors;
with URV.PWM_Steps;   use URV.PWM_Steps;
with URV.Test_Inputs; use URV.Test_Inputs;

package body URV.PWM_Task with SPARK_Mode is

   procedure Run_Transaction is
      Reported : constant Health := Surface_Health.Contents;
      Added    : constant Increments := Test_Added.Contents;
      Item     : Uplink_Buffer;
      Fresh    : Boolean;
   begin
      PWM_Variable.Receive (Item, Fresh);
      PWM_Board.Touch;

      if not Fresh then
         Errors.Report (No_Commands, 0);
      end if;
      if Is_Written (Item, Fresh) then
         PWM_Board.Write (Area_Of (Item, Reported, Added));
      end if;
   end Run_Transaction;

end URV.PWM_Task;
