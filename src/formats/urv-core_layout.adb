--  SPDX-License-Identifier: Apache-2.0

package body URV.CORE_Layout with SPARK_Mode is

   function First_Unknown (Codes : Uplink_Code_List) return Word is
      Where : Uplink_Item := Uplink_Item'First;
   begin
      while Codes (Where) in Uplink_Code loop
         pragma Loop_Invariant
           (for all Earlier in Uplink_Item'First .. Where =>
              Codes (Earlier) in Uplink_Code);
         pragma Loop_Variant (Increases => Uplink_Item'Pos (Where));
         Where := Uplink_Item'Succ (Where);
      end loop;
      return Codes (Where);
   end First_Unknown;

   function First_Unknown (Codes : Downlink_Code_List) return Word is
      Where : Downlink_Item := Downlink_Item'First;
   begin
      while Codes (Where) in Downlink_Code loop
         pragma Loop_Invariant
           (for all Earlier in Downlink_Item'First .. Where =>
              Codes (Earlier) in Downlink_Code);
         pragma Loop_Variant (Increases => Downlink_Item'Pos (Where));
         Where := Downlink_Item'Succ (Where);
      end loop;
      return Codes (Where);
   end First_Unknown;

end URV.CORE_Layout;
