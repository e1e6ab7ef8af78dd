with URV.Routing;

package body URV.GDCOUT_Task with SPARK_Mode is

   procedure Run_Transaction is
      Image   : AD_Image;
      Fresh   : Boolean;
      Success : Boolean;
      Status  : Word;
      Item    : Uplink_Buffer;
   begin
      Receive_AD (Image, Fresh);
      Read_Status (Status);
      Item := Routing.Marked (Routing.To_Uplink (Image), Status);
      if not Fresh then
         Item := Routing.As_Old (Item);
         Report (No_Image, 0);
      end if;

      Send_Uplink (Item, Success);
      if not Success then
         Report (Uplink_Not_Consumed, 0);
      end if;

      Send_TELOUT (Item, Success);
      if not Success then
         Report (Output_Not_Consumed, 0);
      end if;
   end Run_Transaction;

end URV.GDCOUT_Task;
