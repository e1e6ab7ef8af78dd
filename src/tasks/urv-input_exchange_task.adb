--  SPDX-License-Identifier: Apache-2.0

with URVOS; use URVOS;

package body URV.Input_Exchange_Task with SPARK_Mode is

   procedure Run_Transaction is
      Item    : Messages.Message;
      Fresh   : Boolean;
      Success : Boolean;
   begin
      TELIN_Variable.Receive (Item, Fresh);
      if not Fresh then
         Item := As_Old (Item);
         Errors.Report (No_Input, 0);
      elsif First_Out_Of_Range (Item) > 0 then
         Errors.Report (Input_Out_Of_Range, Word (First_Out_Of_Range (Item)));
      end if;

      CORE_Variable.Send (For_CORE (Item), Success);
      if not Success then
         Errors.Report (CORE_Not_Consumed, 0);
      end if;

      Deliver (Item);
   end Run_Transaction;

end URV.Input_Exchange_Task;
