package body URV.Log_Receivers
  with
    SPARK_Mode,
    Refined_State => (Incoming => Coming)
is

   Coming : Receiver := (others => <>);

   procedure Take_Piece (Item : Piece) is
      Complete : Boolean;
   begin
      Take (Coming, Item, Complete);
      if Complete then
         Write_Row (Coming.Which, Coming.Row);
      end if;
   end Take_Piece;

end URV.Log_Receivers;
