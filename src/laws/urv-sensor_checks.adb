--  SPDX-License-Identifier: Apache-2.0

package body URV.Sensor_Checks with SPARK_Mode is

   function Invalid_Bits (Items : Check_Table; Which : Half) return Word is
      Result : Word := 0;
   begin
      for Item in Sensor_Item loop
         if Sensor_Item'Pos (Item) / 16 = Integer (Which)
           and then not Items (Item).Is_Valid
         then
            Result := Result or 2 ** (Sensor_Item'Pos (Item) mod 16);
         end if;
      end loop;
      return Result;
   end Invalid_Bits;

end URV.Sensor_Checks;
