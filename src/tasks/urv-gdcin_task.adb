with URV.Routing;

package body URV.GDCIN_Task with SPARK_Mode is

   procedure Run_Transaction is
      Item    : Downlink_Buffer;
      Fresh   : Boolean;
      Success : Boolean;
   begin
      Receive_TELIN (Item, Fresh);
      if not Fresh then
         Item := Routing.As_Old (Item);
         Report (No_Input, 0);
      elsif Routing.Any_Out_Of_Range (Item) then
         Report
           (Input_Out_Of_Range, Word (Routing.First_Out_Of_Range (Item)));
      end if;

      --  The piece of the aircraft's log goes its own way (SAF-7).
      if not Routing.Is_Old (Item) then
         Take_Piece (Piece_Of (Item (Error_Status)));
      end if;
      Item (Error_Status) := Without_Piece (Item (Error_Status));

      Send_Downlink (Item, Success);
      if not Success then
         Report (Downlink_Not_Consumed, 0);
      end if;
   end Run_Transaction;

end URV.GDCIN_Task;
