--  SPDX-License-Identifier: Apache-2.0

package body URV.Recorder_Blocks with SPARK_Mode is

   function Sum_Of (Block : Downlink_Buffer) return Field is
      Sum : Word := 0;
   begin
      for Item in Summed_Item loop
         Sum := Sum + Weight_Of (Item) * Block (Item);
         pragma Loop_Invariant (Sum = Sum_Up_To (Block, Item));
      end loop;
      return Sum mod 4_096;
   end Sum_Of;

end URV.Recorder_Blocks;
