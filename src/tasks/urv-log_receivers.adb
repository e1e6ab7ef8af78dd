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

end URV.Log_Receivers;
