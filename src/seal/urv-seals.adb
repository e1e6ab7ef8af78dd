--  SPDX-License-Identifier: Apache-2.0

package body URV.Seals with SPARK_Mode is

   procedure Open
     (This  : in out Seal;
      Block : in out Block_Data;
      Came  : Boolean;
      What  : out Outcome)
   is
      Now : constant Seal := A_Frame_Later (This);
   begin
      What := Outcome_Of (Now, Block, Came);
      This := After (Now, Block, What);
      if What not in Taken then
         Block := [others => 0];
      elsif This.Format = 2 then
         Block := Unpacked (Block, Other (This.Role));
      end if;
   end Open;

   procedure Close (This : in out Seal; Data : in out Block_Data) is
      Now : constant Seal := Renewed (This);
   begin
      Data := Closed (Now, Data);
      This := After_Closing (Now);
   end Close;

end URV.Seals;
