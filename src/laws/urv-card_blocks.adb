--  SPDX-License-Identifier: Apache-2.0

package body URV.Card_Blocks with SPARK_Mode is

   function Sum_Of (Source : Card) return Field is
      Sum : Word := 0;
   begin
      for Item in Card_Item loop
         Sum := Sum + Weight_Of (Item) * Source (Item);
         pragma Loop_Invariant (Sum = Sum_Up_To (Source, Item));
      end loop;
      return Sum mod 4_096;
   end Sum_Of;

end URV.Card_Blocks;
