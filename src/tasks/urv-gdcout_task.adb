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
      if not Fresh then
         Report (No_Image, 0);
      end if;
      Read_Status (Status);
      Item := Routing.Marked (Routing.To_Uplink (Image), Status);

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
