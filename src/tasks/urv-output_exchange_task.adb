--  SPDX-License-Identifier: Apache-2.0

package body URV.Output_Exchange_Task with SPARK_Mode is

   procedure Run_Transaction is
      Bits    : constant Word := Node_Status.Contents;
      Image   : AD_Image;
      Fresh   : Boolean;
      Success : Boolean;
      Item    : Messages.Message;
      Unknown : constant Unknown_Count := First_Unknown (Codes);
   begin
      AD_Variable.Receive (Image, Fresh);
      Item := Marked (To_Message (Image, Codes), Bits);
      if Unknown > 0 then
         Errors.Report (Unknown_Code, Codes (Channel (Unknown - 1)));
      end if;
      if not Fresh then
         Item := As_Old (Item);
         Errors.Report (No_Image, 0);
      end if;

      CORE_Variable.Send (Item, Success);
      if not Success then
         Errors.Report (CORE_Not_Consumed, 0);
      end if;

      Add_For_Link (Item);
      TELOUT_Variable.Send (Item, Success);
      if not Success then
         Errors.Report (Output_Not_Consumed, 0);
      end if;
   end Run_Transaction;

end URV.Output_Exchange_Task;
