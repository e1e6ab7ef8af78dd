with URV.Routing;

package body URV.AD_Task with SPARK_Mode is

   procedure Initialise is
   begin
      Begin_Scan;
   end Initialise;

   procedure Run_Transaction is
      Words   : Channel_Words;
      Fresh   : Boolean;
      Success : Boolean;
   begin
      Receive_ADINT (Words, Fresh);
      if not Fresh then
         Report (AD_No_Scan);
      end if;

      Send_AD (Routing.Stamped (Words, Fresh), Success);
      if not Success then
         Report (Image_Not_Consumed);
      end if;

      Begin_Scan;
   end Run_Transaction;

end URV.AD_Task;
