--  SPDX-License-Identifier: Apache-2.0

package body URV.Seals with SPARK_Mode is

   procedure Pass (This : in out Seal; Frames : Counter) is
   begin
      This := After_Frames (This, Frames);
   end Pass;

   procedure Open
     (This  : in out Seal;
      Block : in out Block_Data;
      Came  : Boolean;
      What  : out Outcome) is
   begin
      What := Outcome_Of (This, Block, Came);
      This := After (This, Block, What);
      if What not in Taken then
         Block := [others => 0];
      elsif This.Format = 2 then
         Block := Unpacked (Block, Other (This.Role));
      end if;
   end Open;

   procedure Close (This : in out Seal; Data : in out Block_Data) is
   begin
      This := Renewed (This);
      Data := Closed (This, Data);
   end Close;

end URV.Seals;
