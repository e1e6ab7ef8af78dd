--  SPDX-License-Identifier: Apache-2.0

package body URV.Shared_Seals with SPARK_Mode is

   protected body Shared_Seal is

      procedure Configure
        (Format : Format_Number;
         Keys   : Key_List;
         Start  : Nonce) is
      begin
         Item := New_Seal (Role, Format, Keys, Start);
      end Configure;

      procedure Begin_Anew is
      begin
         Item := Begun_Anew (Item);
      end Begin_Anew;

      procedure Open
        (Block : in out Block_Data;
         Came  : Boolean;
         What  : out Outcome) is
      begin
         Seals.Open (Item, Block, Came, What);
      end Open;

      procedure Close (Data : in out Block_Data) is
      begin
         Seals.Close (Item, Data);
      end Close;

   end Shared_Seal;

end URV.Shared_Seals;
