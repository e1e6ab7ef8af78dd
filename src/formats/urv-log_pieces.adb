--  SPDX-License-Identifier: Apache-2.0

package body URV.Log_Pieces with SPARK_Mode is

   procedure Take
     (This     : in out Receiver;
      Item     : Piece;
      Complete : out Boolean)
   is
      Where : constant Word := Item / 256;
      Value : constant Word := Item mod 256;
   begin
      Complete := False;
      This.Silent := 0;

      if Where = 1 then
         if Value in Word (Log_Row_Number'First) .. Word (Log_Row_Number'Last)
         then
            This := (Got    => 1,
                     Which  => Log_Row_Number (Value),
                     Row    => No_Errors,
                     Silent => 0);
         else
            This.Got := 0;
         end if;

      elsif Where > 1
        and then This.Got > 0
        and then Where = Word (This.Got) + 1
      then
         This.Got := This.Got + 1;
         if Is_High (This.Got) then
            This.Row (Field_At (This.Got)) := Value * 256;
         else
            This.Row (Field_At (This.Got)) :=
              (This.Row (Field_At (This.Got)) and 16#FF00#) or Value;
         end if;
         Complete := This.Got = Place'Last;

      else
         This.Got := 0;
      end if;
   end Take;

end URV.Log_Pieces;
