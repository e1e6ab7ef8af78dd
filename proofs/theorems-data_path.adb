--  SPDX-License-Identifier: Apache-2.0

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

   procedure Sensors_Reach_CORE (Image : AD_Image; Before : Downlink_Buffer)
   is
   begin
      Downlink.Round_Trip (To_Downlink (Image));
      Theorems.Type_Codes.Into_CORE_By_Code
        (Before, Received_Sensors (Image));
   end Sensors_Reach_CORE;

end Theorems.Data_Path;
