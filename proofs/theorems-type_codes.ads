--  SPDX-License-Identifier: Apache-2.0

--  Data goes to the item of its type code, and nowhere else (EXT-2). With the
--  nodes' own codes this gives the same result as the fixed positions of the
--  report. A word with an unknown code is discarded. This holds for every
--  word. The last theorems hold for any list of codes, if no two channels have
--  the same one.

with URV.Buffers;     use URV.Buffers;
with URV.CORE_Layout; use URV.CORE_Layout;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Routing;     use URV.Routing;
with URV.Type_Codes;  use URV.Type_Codes;
with URVOS;           use URVOS;

package Theorems.Type_Codes with Pure, SPARK_Mode, Ghost is

   --  A code identifies one item, and an item has one code.
   procedure A_Code_Is_Of_One_Item
     (Up : Uplink_Item; Down : Downlink_Item; Code : Word)
   with
     Global => null,
     Post   =>
       Uplink_Item_Of (Code_Of (Up)) = Up
       and then Downlink_Item_Of (Code_Of (Down)) = Down
       and then Code_Of (Up) /= Code_Of (Down)
       and then
         (if Code in Uplink_Code then Code_Of (Uplink_Item_Of (Code)) = Code)
       and then
         (if Code in Downlink_Code
          then Code_Of (Downlink_Item_Of (Code)) = Code);

   --  The nodes know the codes of all their channels, and no item has two
   --  channels.
   procedure No_Channel_Is_Unknown
   with
     Global => null,
     Post   =>
       Is_Unique (Stick_Codes)
       and then Is_Unique (Sensor_Codes)
       and then First_Unknown_Command (Stick_Codes) = 0
       and then First_Unknown_Sensor (Sensor_Codes) = 0;

   --  Routing by code equals routing by position, from the converter and into
   --  CORE memory

   procedure From_The_Converter_By_Code (Image : AD_Image)
   with
     Global => null,
     Post   =>
       (for all Item in Command_Item =>
          Commands_Of (Image, Stick_Codes) (Item) =
            Image.Words (Channel_Of (Item)))
       and then
         Commands_Of (Image, Stick_Codes) (Error_Status) =
           Image.Error_Status
       and then
         (for all Item in Sensor_Item =>
            Sensors_Of (Image, Sensor_Codes) (Item) =
              Image.Words (Channel_Of (Item)))
       and then
         Sensors_Of (Image, Sensor_Codes) (Error_Status) =
           Image.Error_Status;

   procedure Into_CORE_By_Code
     (Before : Uplink_Buffer; Source : Uplink_Buffer)
   with
     Global => null,
     Post   =>
       Stored (Uplink_Type_Codes, Before, Source) = Source
       and then not Has_Unknown (Uplink_Type_Codes);

   procedure Into_CORE_By_Code
     (Before : Downlink_Buffer; Source : Downlink_Buffer)
   with
     Global => null,
     Post   =>
       Stored (Downlink_Type_Codes, Before, Source) = Source
       and then not Has_Unknown (Downlink_Type_Codes);

   --  A word with an unknown code changes nothing: two images that differ only
   --  in such words give the same commands and the same sensors.
   procedure An_Unknown_Channel_Has_No_Target
     (One, Other : AD_Image; Codes : Channel_Codes)
   with
     Global => null,
     Pre    =>
       Is_Unique (Codes)
       and then One.Error_Status = Other.Error_Status
       and then
         (for all Where in Channel =>
            (if Codes (Where) in Command_Code or else
               Codes (Where) in Sensor_Code
             then One.Words (Where) = Other.Words (Where))),
     Post   =>
       Commands_Of (One, Codes) = Commands_Of (Other, Codes)
       and then Sensors_Of (One, Codes) = Sensors_Of (Other, Codes);

   --  A place of CORE memory with an unknown code is not written

   procedure An_Unknown_Place_Stays
     (Codes  : Uplink_Code_List;
      Before : Uplink_Buffer;
      Source : Uplink_Buffer;
      Where  : Uplink_Item)
   with
     Global => null,
     Pre    => Codes (Where) not in Uplink_Code,
     Post   =>
       Stored (Codes, Before, Source) (Where) = Before (Where)
       and then Has_Unknown (Codes);

   procedure An_Unknown_Place_Stays
     (Codes  : Downlink_Code_List;
      Before : Downlink_Buffer;
      Source : Downlink_Buffer;
      Where  : Downlink_Item)
   with
     Global => null,
     Pre    => Codes (Where) not in Downlink_Code,
     Post   =>
       Stored (Codes, Before, Source) (Where) = Before (Where)
       and then Has_Unknown (Codes);

end Theorems.Type_Codes;
