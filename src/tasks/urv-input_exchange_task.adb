--  SPDX-License-Identifier: Apache-2.0

package body URV.Input_Exchange_Task with SPARK_Mode is

   --  What CORE was given last, as old.
   procedure Get_Last (Item : out Messages.Message);

   procedure Get_Last (Item : out Messages.Message) is
      Last : constant Messages.Boxes.Mailbox := CORE_Variable.Snapshot;
   begin
      Item := As_Old (Messages.Boxes.Contents (Last));
   end Get_Last;

   procedure Run_Transaction is
      Item    : Messages.Message;
      Fresh   : Boolean;
      Taken   : Boolean;
      Success : Boolean;
   begin
      TELIN_Variable.Receive (Item, Fresh);
      if not Fresh then
         Errors.Report (No_Input, 0);
      end if;

      if Is_Other_Kind (Item) then
         if Fresh then
            Deliver_Other (Item, Taken);
            if not Taken then
               Errors.Report (Unknown_Code, Kind_Of (Item));
            end if;
         end if;
         Get_Last (Item);
      elsif not Fresh then
         Item := As_Old (Item);
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
