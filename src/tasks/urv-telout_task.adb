package body URV.TELOUT_Task with SPARK_Mode is

   procedure Run_Transaction is
      Item      : Message;
      Fresh     : Boolean;
      Overwrote : Boolean;
   begin
      Receive_TELOUT (Item, Fresh);

      if Fresh then
         Put_Block (Encode (Item), Overwrote);
         if Overwrote then
            Report (TELOUT_Overwrote_Block, 0);
         end if;
      else
         Report (No_Output, 0);
      end if;
   end Run_Transaction;

end URV.TELOUT_Task;
