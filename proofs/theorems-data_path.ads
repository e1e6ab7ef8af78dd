--  SPDX-License-Identifier: Apache-2.0

--  Words arrive unchanged from end to end: each stick word reaches the servo
--  of figure 13, and each sensor word the ground's CORE memory (BUF-1, BUF-2,
--  PWM-2, D-2, FTI-12). This holds for every word of a converter, through
--  routing, codec, transform and layout. It assumes that the block itself
--  arrives intact, with the laws off and no failed surface.

with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Codecs;        use URV.Codecs;
with URV.CORE_Layout;   use URV.CORE_Layout;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Plain_Blocks;  use URV.Plain_Blocks;
with URV.PWM_Layout;    use URV.PWM_Layout;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Routing;       use URV.Routing;
with URV.Spare_Bits;

package Theorems.Data_Path with Pure, SPARK_Mode, Ghost is

   --  The aircraft's decoded commands from an image of the ground's converter.
   function Received_Commands (Image : AD_Image) return Uplink_Buffer is
     (Uplink.Buffer_Of
        (Decode
           (Encode (Uplink.Words_Of (To_Uplink (Image)), Uplink.Words),
            Uplink.Words)));

   --  The ground's decoded downlink from an image of the aircraft's converter
   --  with any frame in its spare bits (FTI-12).
   function Received_Downlink (Image : AD_Image; Frame : Frame_Words)
                               return Framed_Downlink
   is
     (URV.Spare_Bits.Unpacked
        (Downlink.Buffer_Of
           (Decode
              (Encode
                 (Downlink.Words_Of
                    (URV.Spare_Bits.Packed (To_Downlink (Image), Frame)),
                  Downlink.Words),
               Downlink.Words))));

   --  Every stick word of the ground's converter reaches the aircraft.
   procedure Commands_Arrive (Image : AD_Image)
   with
     Global => null,
     Post   =>
       (for all Item in Command_Item =>
          Received_Commands (Image) (Item) =
            Image.Words (Channel_Of (Item)))
       and then Received_Commands (Image) (Error_Status) =
                  Image.Error_Status;

   --  From there it reaches the servo of figure 13, limited to 12 bits.
   procedure Commands_Reach_The_Servos (Image : AD_Image)
   with
     Global => null,
     Post   =>
       (for all Item in PWM_Item =>
          To_Data_Area (Transform (Received_Commands (Image)))
            (URV.PWM_Layout.Channel_Of (Item)) =
            (case Item is
                when Left_Aileron | Right_Aileron =>
                  Clipped (Image.Words (0)),
                when Left_Elevator | Right_Elevator =>
                  Clipped (Image.Words (1)),
                when Left_Rudder | Right_Rudder | Steering =>
                  Clipped (Image.Words (2)),
                when Throttle =>
                  Clipped (Image.Words (3)),
                when Brake =>
                  Clipped (Image.Words (4)),
                when Left_Flap_1 | Right_Flap_1
                   | Left_Flap_2 | Right_Flap_2 =>
                  (if Is_On (Image.Words (12)) then 16#FFF# else 16#800#),
                when Discretes =>
                  Packed_Switches (Received_Commands (Image))));

   --  Every sensor word of the aircraft's converter reaches the ground's CORE
   --  memory, limited to 12 bits, whatever the spare bits carry. The frame
   --  arrives unchanged.
   procedure Sensors_Reach_CORE
     (Image : AD_Image; Frame : Frame_Words; Before : Downlink_Buffer)
   with
     Global => null,
     Post   =>
       (for all Item in Sensor_Item =>
          Stored
            (Downlink_Type_Codes, Before,
             Received_Downlink (Image, Frame).Words)
            (Item) =
            URV.Spare_Bits.Clipped (Image.Words (Channel_Of (Item))))
       and then
         Stored
           (Downlink_Type_Codes, Before,
            Received_Downlink (Image, Frame).Words)
           (Error_Status) =
           Image.Error_Status
       and then
         (if URV.Spare_Bits.Is_Sendable (Frame)
          then
            (for all Item in Frame_Item =>
               Received_Downlink (Image, Frame).Frame (Item) =
                 Frame (Item)));

   --  After a start of any kind no word in CORE counts as fresh until a
   --  message arrives. A warm start keeps every word (INI-6, SAF-5).
   procedure A_Start_Leaves_Nothing_Fresh (CORE : Memory)
   with
     Global => null,
     Post   =>
       Is_Old (Cleared.Uplink)
       and then Is_Old (Cleared.Downlink)
       and then Is_Old (Marked_Old (CORE).Uplink)
       and then Is_Old (Marked_Old (CORE).Downlink)
       and then
         (for all Item in Command_Item =>
            Marked_Old (CORE).Uplink (Item) = CORE.Uplink (Item))
       and then
         (for all Item in Sensor_Item =>
            Marked_Old (CORE).Downlink (Item) = CORE.Downlink (Item));

end Theorems.Data_Path;
