--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Type_Codes with SPARK_Mode is

   procedure A_Code_Is_Of_One_Item
     (Up : Uplink_Item; Down : Downlink_Item; Code : Word) is null;

   procedure No_Channel_Is_Unknown is null;

   procedure From_The_Converter_By_Code (Image : AD_Image) is
   begin
      pragma Assert (To_Uplink (Image) = Commands_Of (Image, Stick_Codes));
      pragma Assert
        (To_Downlink (Image) = Sensors_Of (Image, Sensor_Codes));
   end From_The_Converter_By_Code;

   procedure Into_CORE_By_Code
     (Before : Uplink_Buffer; Source : Uplink_Buffer)
   is
      Codes : constant Uplink_Code_List := Uplink_Type_Codes;
   begin
      for Item in Uplink_Item loop
         A_Code_Is_Of_One_Item (Item, Downlink_Item'First, 0);
         pragma Loop_Invariant
           (for all Earlier in Uplink_Item'First .. Item =>
              Codes (Earlier) in Uplink_Code
              and then Stored (Codes, Before, Source) (Earlier) =
                         Source (Earlier));
      end loop;
   end Into_CORE_By_Code;

   procedure Into_CORE_By_Code
     (Before : Downlink_Buffer; Source : Downlink_Buffer)
   is
      Codes : constant Downlink_Code_List := Downlink_Type_Codes;
   begin
      for Item in Downlink_Item loop
         A_Code_Is_Of_One_Item (Uplink_Item'First, Item, 0);
         pragma Loop_Invariant
           (for all Earlier in Downlink_Item'First .. Item =>
              Codes (Earlier) in Downlink_Code
              and then Stored (Codes, Before, Source) (Earlier) =
                         Source (Earlier));
      end loop;
   end Into_CORE_By_Code;

   procedure An_Unknown_Channel_Has_No_Target
     (One, Other : AD_Image; Codes : Channel_Codes) is
   begin
      for Item in Command_Item loop
         A_Code_Is_Of_One_Item (Item, Right_Flap_1, 0);
         pragma Loop_Invariant
           (for all Earlier in Roll .. Item =>
              Commands_Of (One, Codes) (Earlier) =
                Commands_Of (Other, Codes) (Earlier));
      end loop;
      for Item in Sensor_Item loop
         A_Code_Is_Of_One_Item (Roll, Item, 0);
         pragma Loop_Invariant
           (for all Earlier in Right_Flap_1 .. Item =>
              Sensors_Of (One, Codes) (Earlier) =
                Sensors_Of (Other, Codes) (Earlier));
      end loop;
   end An_Unknown_Channel_Has_No_Target;

   procedure An_Unknown_Place_Stays
     (Codes  : Uplink_Code_List;
      Before : Uplink_Buffer;
      Source : Uplink_Buffer;
      Where  : Uplink_Item) is null;

   procedure An_Unknown_Place_Stays
     (Codes  : Downlink_Code_List;
      Before : Downlink_Buffer;
      Source : Downlink_Buffer;
      Where  : Downlink_Item) is null;

end Theorems.Type_Codes;
