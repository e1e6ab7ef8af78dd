--  SPDX-License-Identifier: Apache-2.0

package body URV.Routing with SPARK_Mode is

   function To_Uplink (Image : AD_Image) return Uplink_Buffer is
      Result : Uplink_Buffer := (others => Image.Error_Status);
   begin
      for Item in Command_Item loop
         Result (Item) := Image.Words (Channel_Of (Item));
         pragma Loop_Invariant
           (for all Earlier in Roll .. Item =>
              Result (Earlier) = Image.Words (Channel_Of (Earlier)));
         pragma Loop_Invariant (Result (Error_Status) = Image.Error_Status);
      end loop;
      return Result;
   end To_Uplink;

   function To_Downlink (Image : AD_Image) return Downlink_Buffer is
      Result : Downlink_Buffer := (others => Image.Error_Status);
   begin
      for Item in Sensor_Item loop
         Result (Item) := Image.Words (Channel_Of (Item));
         pragma Loop_Invariant
           (for all Earlier in Right_Flap_1 .. Item =>
              Result (Earlier) = Image.Words (Channel_Of (Earlier)));
         pragma Loop_Invariant (Result (Error_Status) = Image.Error_Status);
      end loop;
      return Result;
   end To_Downlink;

   function First_Out_Of_Range (Source : Uplink_Buffer) return Place_Count is
   begin
      for Item in Command_Item loop
         if Is_Out_Of_Range (Source (Item)) then
            return Command_Item'Pos (Item) + 1;
         end if;
         pragma Loop_Invariant
           (for all Earlier in Roll .. Item =>
              not Is_Out_Of_Range (Source (Earlier)));
      end loop;
      return 0;
   end First_Out_Of_Range;

   function First_Out_Of_Range (Source : Downlink_Buffer) return Place_Count is
   begin
      for Item in Sensor_Item loop
         if Is_Out_Of_Range (Source (Item)) then
            return Sensor_Item'Pos (Item) + 1;
         end if;
         pragma Loop_Invariant
           (for all Earlier in Right_Flap_1 .. Item =>
              not Is_Out_Of_Range (Source (Earlier)));
      end loop;
      return 0;
   end First_Out_Of_Range;

end URV.Routing;
