--  SPDX-License-Identifier: Apache-2.0

package body URV.Seals with SPARK_Mode is

   procedure Open
     (Item  : in out Seal;
      Block : in out Block_Data;
      Came  : Boolean;
      What  : out Outcome)
   is
      Now : constant Seal := A_Frame_Later (Item);
   begin
      What := Outcome_Of (Now, Block, Came);
      Item := After (Now, Block, What);
      if What not in Taken then
         Block := [others => 0];
      elsif Item.Format = 2 then
         Block := Unpacked (Block, Other (Item.Role));
      end if;
   end Open;

   procedure Close (Item : in out Seal; Data : in out Block_Data) is
      Now : constant Seal := Renewed (Item);
   begin
      Data := Closed (Now, Data);
      Item := After_Closing (Now);
   end Close;

end URV.Seals;
