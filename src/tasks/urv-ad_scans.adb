--  SPDX-License-Identifier: Apache-2.0

package body URV.AD_Scans with SPARK_Mode is

   procedure Store
     (Item  : in out Scan;
      Value : Word;
      Next  : out Next_Step)
   is
   begin
      if Is_Complete (Item) then
         Next := Ignore;
      else
         Item.Words (Channel (Item.Current)) := Value;
         Item.Current := Item.Current + 1;
         Next := (if Is_Complete (Item) then Send_Words else Start_Channel);
      end if;
   end Store;

end URV.AD_Scans;
