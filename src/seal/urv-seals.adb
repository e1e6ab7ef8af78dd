--  SPDX-License-Identifier: Apache-2.0

package body URV.Seals with SPARK_Mode is

   procedure Pass (This : in out Seal; Frames : Counter) is
   begin
      This := After_Frames (This, Frames);
   end Pass;

   procedure Open
     (This    : in out Seal;
      Block   : in out Block_Data;
      Arrived : Boolean;
      Result  : out Outcome) is
   begin
      Result := Outcome_Of (This, Block, Arrived);
      if This.Format = 2 then
         This := After (This, Block, Result);
      end if;
      if Result not in Taken then
         Block := [others => 0];
      elsif This.Format = 2 then
         Block := Unpacked (Block, Other (This.Role));
      end if;
   end Open;

   procedure Close (This : in out Seal; Data : in out Block_Data) is
   begin
      if This.Active.Is_Present and then This.Active.Age = Last_Age then
         This := Restarted (This);
      end if;
      if This.Format = 2 then
         Data := Closed (This, Data);
      end if;
   end Close;

end URV.Seals;
