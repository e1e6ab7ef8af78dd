--  SPDX-License-Identifier: Apache-2.0

package body URV.CORE_Layout with SPARK_Mode is

   function Uplink_Type_Codes return Uplink_Words is
      Result : Uplink_Words := (others => 0);
   begin
      for Item in Uplink_Item loop
         Result (Place (Item)) := Type_Code (Item);
         pragma Loop_Invariant
           (for all Earlier in Uplink_Item'First .. Item =>
              Result (Place (Earlier)) = Type_Code (Earlier));
      end loop;
      return Result;
   end Uplink_Type_Codes;

   function Downlink_Type_Codes return Downlink_Words is
      Result : Downlink_Words := (others => 0);
   begin
      for Item in Downlink_Item loop
         Result (Place (Item)) := Type_Code (Item);
         pragma Loop_Invariant
           (for all Earlier in Downlink_Item'First .. Item =>
              Result (Place (Earlier)) = Type_Code (Earlier));
      end loop;
      return Result;
   end Downlink_Type_Codes;

   function Status_Type_Codes return Status_Words is
      Result : Status_Words := (others => 0);
   begin
      for Item in Status_Item loop
         Result (Item) := Type_Code (Item);
         pragma Loop_Invariant
           (for all Earlier in Status_Item'First .. Item =>
              Result (Earlier) = Type_Code (Earlier));
      end loop;
      return Result;
   end Status_Type_Codes;

   function To_Words (Source : Uplink_Buffer) return Uplink_Words is
      Result : Uplink_Words := (others => 0);
   begin
      for Item in Uplink_Item loop
         Result (Place (Item)) := Source (Item);
         pragma Loop_Invariant
           (for all Earlier in Uplink_Item'First .. Item =>
              Result (Place (Earlier)) = Source (Earlier));
      end loop;
      return Result;
   end To_Words;

   function To_Words (Source : Downlink_Buffer) return Downlink_Words is
      Result : Downlink_Words := (others => 0);
   begin
      for Item in Downlink_Item loop
         Result (Place (Item)) := Source (Item);
         pragma Loop_Invariant
           (for all Earlier in Downlink_Item'First .. Item =>
              Result (Place (Earlier)) = Source (Earlier));
      end loop;
      return Result;
   end To_Words;

   function To_Buffer (Source : Uplink_Words) return Uplink_Buffer is
      Result : Uplink_Buffer := (others => 0);
   begin
      for Item in Uplink_Item loop
         Result (Item) := Source (Place (Item));
         pragma Loop_Invariant
           (for all Earlier in Uplink_Item'First .. Item =>
              Result (Earlier) = Source (Place (Earlier)));
      end loop;
      return Result;
   end To_Buffer;

   function To_Buffer (Source : Downlink_Words) return Downlink_Buffer is
      Result : Downlink_Buffer := (others => 0);
   begin
      for Item in Downlink_Item loop
         Result (Item) := Source (Place (Item));
         pragma Loop_Invariant
           (for all Earlier in Downlink_Item'First .. Item =>
              Result (Earlier) = Source (Place (Earlier)));
      end loop;
      return Result;
   end To_Buffer;

end URV.CORE_Layout;
