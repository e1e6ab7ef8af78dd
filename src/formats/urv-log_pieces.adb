--  SPDX-License-Identifier: Apache-2.0

package body URV.Log_Pieces with SPARK_Mode is

   procedure Take
     (Item     : in out Receiver;
      What     : Piece;
      Complete : out Boolean)
   is
      Where : constant Word := What / 256;
      Value : constant Word := What mod 256;
   begin
      Complete := False;

      if Where = 1 then
         if Value in Word (Log_Row_Number'First) .. Word (Log_Row_Number'Last)
         then
            Item := (Got   => 1,
                     Which => Log_Row_Number (Value),
                     Row   => No_Errors);
         else
            Item.Got := 0;
         end if;

      elsif Where > 1
        and then Item.Got > 0
        and then Where = Word (Item.Got) + 1
      then
         Item.Got := Item.Got + 1;
         if Is_High (Item.Got) then
            Item.Row (Field_At (Item.Got)) := Value * 256;
         else
            Item.Row (Field_At (Item.Got)) :=
              (Item.Row (Field_At (Item.Got)) and 16#FF00#) or Value;
         end if;
         Complete := Item.Got = Place'Last;

      else
         Item.Got := 0;
      end if;
   end Take;

end URV.Log_Pieces;
