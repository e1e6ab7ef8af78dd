--  SPDX-License-Identifier: Apache-2.0

--  The part of the converter image that each node passes on (report, 4.7, 5.6,
--  D-14, D-15). Each channel goes to the item of its type code (EXT-2).

with URVOS;          use URVOS;
with URV.Buffers;    use URV.Buffers;
with URV.Type_Codes; use URV.Type_Codes;

package URV.Routing with Pure, SPARK_Mode is

   --  The channel of an item: the first channel has the first item, and so on.
   function Channel_Of (Item : Command_Item) return Channel is
     (Channel (Command_Item'Pos (Item)))
   with Global => null;

   function Channel_Of (Item : Sensor_Item) return Channel is
     (Channel (Sensor_Item'Pos (Item)))
   with Global => null;

   --  The commands and, as 14th word, the error/status word (GDO-1). An item
   --  without a channel is neutral. If two channels have the same item, the
   --  later one counts.
   function Commands_Of
     (Image : AD_Image; Codes : Channel_Codes) return Uplink_Buffer
   with
     Global => null,
     Post   =>
       (if Is_Unique (Codes)
        then
          (for all From in Channel =>
             (if Codes (From) in Command_Code
              then Commands_Of'Result (Uplink_Item_Of (Codes (From))) =
                     Image.Words (From))))
       and then
         (for all Item in Command_Item =>
            (if (for all From in Channel => Codes (From) /= Code_Of (Item))
             then Commands_Of'Result (Item) = Neutral_Uplink (Item)))
       and then Commands_Of'Result (Error_Status) = Image.Error_Status;

   --  The sensors and, as 28th word, the error/status word (MDO-1, D-1).
   function Sensors_Of
     (Image : AD_Image; Codes : Channel_Codes) return Downlink_Buffer
   with
     Global => null,
     Post   =>
       (if Is_Unique (Codes)
        then
          (for all From in Channel =>
             (if Codes (From) in Sensor_Code
              then Sensors_Of'Result (Downlink_Item_Of (Codes (From))) =
                     Image.Words (From))))
       and then
         (for all Item in Sensor_Item =>
            (if (for all From in Channel => Codes (From) /= Code_Of (Item))
             then Sensors_Of'Result (Item) = Neutral_Downlink (Item)))
       and then Sensors_Of'Result (Error_Status) = Image.Error_Status;

   --  With the node's own codes, each item has the channel of its order

   function To_Uplink (Image : AD_Image) return Uplink_Buffer
   with
     Global => null,
     Post   =>
       To_Uplink'Result = Commands_Of (Image, Stick_Codes)
       and then
       (for all Item in Command_Item =>
          To_Uplink'Result (Item) = Image.Words (Channel_Of (Item)))
       and then To_Uplink'Result (Error_Status) = Image.Error_Status;

   function To_Downlink (Image : AD_Image) return Downlink_Buffer
   with
     Global => null,
     Post   =>
       To_Downlink'Result = Sensors_Of (Image, Sensor_Codes)
       and then
       (for all Item in Sensor_Item =>
          To_Downlink'Result (Item) = Image.Words (Channel_Of (Item)))
       and then To_Downlink'Result (Error_Status) = Image.Error_Status;

   --  The first channel with an unknown code, from 1; 0 if there is none

   type Unknown_Count is range 0 .. Channel'Pos (Channel'Last) + 1;

   function First_Unknown_Command (Codes : Channel_Codes)
                                   return Unknown_Count
   with
     Global => null,
     Post   =>
       (if First_Unknown_Command'Result = 0
        then (for all From in Channel =>
                Codes (From) in Command_Code | No_Code)
        else Codes (Channel (First_Unknown_Command'Result - 1))
               not in Command_Code | No_Code);

   function First_Unknown_Sensor (Codes : Channel_Codes)
                                  return Unknown_Count
   with
     Global => null,
     Post   =>
       (if First_Unknown_Sensor'Result = 0
        then (for all From in Channel =>
                Codes (From) in Sensor_Code | No_Code)
        else Codes (Channel (First_Unknown_Sensor'Result - 1))
               not in Sensor_Code | No_Code);

   --  The image of a scan, with the mark of an earlier frame unless Fresh
   --  (AD-1).
   function Stamped
     (Words : Channel_Words;
      Fresh : Boolean) return AD_Image
   is
     (Words        => Words,
      Error_Status => (if Fresh then No_Error else Stale_Data))
   with Global => null;

   --  A word beyond the range of a 12-bit converter (D-11).
   function Is_Out_Of_Range (Value : Word) return Boolean is
     (Value not in Converter_Value)
   with Global => null;

   function Any_Out_Of_Range (Source : Uplink_Buffer) return Boolean is
     (for some Item in Command_Item => Is_Out_Of_Range (Source (Item)))
   with Global => null;

   function Any_Out_Of_Range (Source : Downlink_Buffer) return Boolean is
     (for some Item in Sensor_Item => Is_Out_Of_Range (Source (Item)))
   with Global => null;

   --  A word's place in its buffer, from 1; 0 means none.
   type Place_Count is
     range 0 .. Downlink_Item'Pos (Downlink_Item'Last) + 1;

   --  The place of the first word that is out of range

   function First_Out_Of_Range (Source : Uplink_Buffer) return Place_Count
   with
     Global => null,
     Post   =>
       (if not Any_Out_Of_Range (Source)
        then First_Out_Of_Range'Result = 0
        else (for some Item in Command_Item =>
                First_Out_Of_Range'Result = Command_Item'Pos (Item) + 1
                and then Is_Out_Of_Range (Source (Item))
                and then
                  (for all Earlier in Command_Item =>
                     (if Earlier < Item
                      then not Is_Out_Of_Range (Source (Earlier))))));

   function First_Out_Of_Range (Source : Downlink_Buffer) return Place_Count
   with
     Global => null,
     Post   =>
       (if not Any_Out_Of_Range (Source)
        then First_Out_Of_Range'Result = 0
        else (for some Item in Sensor_Item =>
                First_Out_Of_Range'Result = Sensor_Item'Pos (Item) + 1
                and then Is_Out_Of_Range (Source (Item))
                and then
                  (for all Earlier in Sensor_Item =>
                     (if Earlier < Item
                      then not Is_Out_Of_Range (Source (Earlier))))));

end URV.Routing;
