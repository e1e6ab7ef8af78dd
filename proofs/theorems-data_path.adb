--  SPDX-License-Identifier: Apache-2.0

with Theorems.Spare_Bits;
with Theorems.Type_Codes;

package body Theorems.Data_Path with SPARK_Mode is

   procedure Commands_Arrive (Image : AD_Image) is
   begin
      Uplink.Round_Trip (To_Uplink (Image));
   end Commands_Arrive;

   procedure Commands_Reach_The_Servos (Image : AD_Image) is
   begin
      Commands_Arrive (Image);
   end Commands_Reach_The_Servos;

   procedure Sensors_Reach_CORE
     (Image : AD_Image; Frame : Frame_Words; Before : Downlink_Buffer)
   is
      Sent : constant Downlink_Buffer :=
        URV.Spare_Bits.Packed (To_Downlink (Image), Frame);
      Came : constant Downlink_Buffer :=
        Downlink.Buffer_Of
          (Decode
             (Encode (Downlink.Words_Of (Sent), Downlink.Words),
              Downlink.Words));
   begin
      Downlink.Round_Trip (Sent);
      Theorems.Spare_Bits.What_Is_Packed_Comes
        (To_Downlink (Image), Frame);
      Theorems.Spare_Bits.Equal_Words_Have_Equal_Frames (Came, Sent);
      pragma Assert
        (for all Item in Downlink_Item =>
           Received_Downlink (Image, Frame).Words (Item) =
             URV.Spare_Bits.Sensors_In (Came) (Item));
      Theorems.Type_Codes.Into_CORE_By_Code
        (Before, Received_Downlink (Image, Frame).Words);
   end Sensors_Reach_CORE;

   procedure A_Start_Leaves_Nothing_Fresh (CORE : Memory) is null;

end Theorems.Data_Path;
