with URV.Routing;

package body URV.MDCIN_Task with SPARK_Mode is

   procedure Run_Transaction is
      Item    : Uplink_Buffer;
      Fresh   : Boolean;
      Success : Boolean;
   begin
      Receive_TELIN (Item, Fresh);
      if not Fresh then
         Report (No_Input);
      elsif Routing.Any_Out_Of_Range (Item) then
         Report (Input_Out_Of_Range);
      end if;

      Send_Uplink (Item, Success);
      if not Success then
         Report (Uplink_Not_Consumed);
      end if;

      Send_PWM (Item, Success);
      if not Success then
         Report (Commands_Not_Consumed);
      end if;
   end Run_Transaction;

end URV.MDCIN_Task;
