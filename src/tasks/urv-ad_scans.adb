--  SPDX-License-Identifier: Apache-2.0

package body URV.AD_Scans with SPARK_Mode is

   procedure Begin_Again (This : in out Scan) is
   begin
      This.Current := 0;
   end Begin_Again;

   procedure Store
     (This  : in out Scan;
      Value : Word;
      Next  : out Next_Step)
   is
   begin
      if Is_Complete (This) then
         Next := Ignore;
      else
         This.Words (Channel (This.Current)) := Value;
         This.Current := This.Current + 1;
         Next := (if Is_Complete (This) then Send_Words else Start_Channel);
      end if;
   end Store;

end URV.AD_Scans;
