--  SPDX-License-Identifier: Apache-2.0

package body URV.Log_Receivers with SPARK_Mode is

   procedure Take_Piece (Item : Piece) is
      Coming   : Receiver := Incoming.Contents;
      Complete : Boolean;
   begin
      Take (Coming, Item, Complete);
      Incoming.Write (Coming);
      if Complete then
         CORE_Memory.Write_Aircraft_Log (Coming.Which, Coming.Row);
      end if;
   end Take_Piece;

   procedure Miss_Piece is
      Coming : constant Receiver := Incoming.Contents;
   begin
      Incoming.Write (After_Silence (Coming));
   end Miss_Piece;

   procedure Restart is
   begin
      Incoming.Write ((others => <>));
   end Restart;

end URV.Log_Receivers;
