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

   function Stored
     (Codes  : Uplink_Words;
      Before : Uplink_Words;
      Source : Uplink_Buffer) return Uplink_Words
   is
      Result : Uplink_Words := Before;
   begin
      for Where in Result'Range loop
         if Codes (Where) in Uplink_Code then
            Result (Where) := Source (Uplink_Item_Of (Codes (Where)));
         end if;
         pragma Loop_Invariant
           (for all Place in Result'Range =>
              Result (Place) =
                (if Place <= Where and then Codes (Place) in Uplink_Code
                 then Source (Uplink_Item_Of (Codes (Place)))
                 else Before (Place)));
      end loop;
      return Result;
   end Stored;

   function Stored
     (Codes  : Downlink_Words;
      Before : Downlink_Words;
      Source : Downlink_Buffer) return Downlink_Words
   is
      Result : Downlink_Words := Before;
   begin
      for Where in Result'Range loop
         if Codes (Where) in Downlink_Code then
            Result (Where) := Source (Downlink_Item_Of (Codes (Where)));
         end if;
         pragma Loop_Invariant
           (for all Place in Result'Range =>
              Result (Place) =
                (if Place <= Where and then Codes (Place) in Downlink_Code
                 then Source (Downlink_Item_Of (Codes (Place)))
                 else Before (Place)));
      end loop;
      return Result;
   end Stored;

   function First_Unknown_Uplink (Codes : Uplink_Words) return Place_Or_None
   is
   begin
      for Where in Codes'Range loop
         if Codes (Where) not in Uplink_Code then
            return Place_Or_None (Where);
         end if;
         pragma Loop_Invariant
           (for all Place in Codes'First .. Where =>
              Codes (Place) in Uplink_Code);
      end loop;
      return 0;
   end First_Unknown_Uplink;

   function First_Unknown_Downlink
     (Codes : Downlink_Words) return Place_Or_None
   is
   begin
      for Where in Codes'Range loop
         if Codes (Where) not in Downlink_Code then
            return Place_Or_None (Where);
         end if;
         pragma Loop_Invariant
           (for all Place in Codes'First .. Where =>
              Codes (Place) in Downlink_Code);
      end loop;
      return 0;
   end First_Unknown_Downlink;

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
