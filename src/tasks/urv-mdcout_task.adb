with URV.Routing;

package body URV.MDCOUT_Task with SPARK_Mode is

   procedure Run_Transaction is
      Image     : AD_Image;
      Fresh     : Boolean;
      Success   : Boolean;
      Status    : Word;
      Log_Piece : Piece;
      Item      : Downlink_Buffer;
   begin
      Receive_AD (Image, Fresh);
      Read_Status (Status);
      Item := Routing.Marked (Routing.To_Downlink (Image), Status);
      if not Fresh then
         Item := Routing.As_Old (Item);
         Report (No_Image, 0);
      end if;

      Send_Downlink (Item, Success);
      if not Success then
         Report (Downlink_Not_Consumed, 0);
      end if;

      Next_Piece (Log_Piece);
      Item (Error_Status) := With_Piece (Item (Error_Status), Log_Piece);
      Send_TELOUT (Item, Success);
      if not Success then
         Report (Output_Not_Consumed, 0);
      end if;
   end Run_Transaction;

end URV.MDCOUT_Task;
