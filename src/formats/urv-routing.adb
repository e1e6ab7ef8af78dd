--  SPDX-License-Identifier: Apache-2.0

package body URV.Routing with SPARK_Mode is

   --  The channel of an item has its code.
   procedure Prove_Sticks
   with
     Ghost,
     Global => null,
     Post   =>
       (for all Item in Command_Item =>
          Stick_Codes (Channel_Of (Item)) in Command_Code
          and then Uplink_Item_Of (Stick_Codes (Channel_Of (Item))) = Item);

   --  The channel of an item has its code.
   procedure Prove_Sensors
   with
     Ghost,
     Global => null,
     Post   =>
       (for all Item in Sensor_Item =>
          Sensor_Codes (Channel_Of (Item)) in Sensor_Code
          and then Downlink_Item_Of (Sensor_Codes (Channel_Of (Item))) = Item);

   procedure Prove_Sticks is
   begin
      for Item in Command_Item loop
         pragma Assert (Stick_Codes (Channel_Of (Item)) = Code_Of (Item));
         pragma Assert (Uplink_Item_Of (Code_Of (Item)) = Item);
         pragma Loop_Invariant
           (for all Earlier in Roll .. Item =>
              Stick_Codes (Channel_Of (Earlier)) in Command_Code
              and then Uplink_Item_Of (Stick_Codes (Channel_Of (Earlier))) =
                         Earlier);
      end loop;
   end Prove_Sticks;

   procedure Prove_Sensors is
   begin
      for Item in Sensor_Item loop
         pragma Assert (Sensor_Codes (Channel_Of (Item)) = Code_Of (Item));
         pragma Assert (Downlink_Item_Of (Code_Of (Item)) = Item);
         pragma Loop_Invariant
           (for all Earlier in Right_Flap_1 .. Item =>
              Sensor_Codes (Channel_Of (Earlier)) in Sensor_Code
              and then Downlink_Item_Of (Sensor_Codes (Channel_Of (Earlier))) =
                         Earlier);
      end loop;
   end Prove_Sensors;

   function Commands_Of
     (Image : AD_Image; Codes : Channel_Codes) return Uplink_Buffer
   is
      Result : Uplink_Buffer :=
        (Neutral_Uplink with delta Error_Status => Image.Error_Status);
   begin
      for From in Channel loop
         if Codes (From) in Command_Code then
            Result (Uplink_Item_Of (Codes (From))) := Image.Words (From);
         end if;
         pragma Loop_Invariant
           (if Is_Unique (Codes)
            then
              (for all Earlier in Channel =>
                 (if Earlier <= From and then Codes (Earlier) in Command_Code
                  then Result (Uplink_Item_Of (Codes (Earlier))) =
                         Image.Words (Earlier))));
         pragma Loop_Invariant
           (for all Item in Command_Item =>
              (if (for all Earlier in Channel =>
                     (if Earlier <= From
                      then Codes (Earlier) /= Code_Of (Item)))
               then Result (Item) = Neutral_Uplink (Item)));
         pragma Loop_Invariant (Result (Error_Status) = Image.Error_Status);
      end loop;
      return Result;
   end Commands_Of;

   function Sensors_Of
     (Image : AD_Image; Codes : Channel_Codes) return Downlink_Buffer
   is
      Result : Downlink_Buffer :=
        (Neutral_Downlink with delta Error_Status => Image.Error_Status);
   begin
      for From in Channel loop
         if Codes (From) in Sensor_Code then
            Result (Downlink_Item_Of (Codes (From))) := Image.Words (From);
         end if;
         pragma Loop_Invariant
           (if Is_Unique (Codes)
            then
              (for all Earlier in Channel =>
                 (if Earlier <= From and then Codes (Earlier) in Sensor_Code
                  then Result (Downlink_Item_Of (Codes (Earlier))) =
                         Image.Words (Earlier))));
         pragma Loop_Invariant
           (for all Item in Sensor_Item =>
              (if (for all Earlier in Channel =>
                     (if Earlier <= From
                      then Codes (Earlier) /= Code_Of (Item)))
               then Result (Item) = Neutral_Downlink (Item)));
         pragma Loop_Invariant (Result (Error_Status) = Image.Error_Status);
      end loop;
      return Result;
   end Sensors_Of;

   function To_Uplink (Image : AD_Image) return Uplink_Buffer is
   begin
      Prove_Sticks;
      return Commands_Of (Image, Stick_Codes);
   end To_Uplink;

   function To_Downlink (Image : AD_Image) return Downlink_Buffer is
   begin
      Prove_Sensors;
      return Sensors_Of (Image, Sensor_Codes);
   end To_Downlink;

   function First_Unknown_Command (Codes : Channel_Codes)
                                  return Unknown_Count is
   begin
      for From in Channel loop
         if Codes (From) not in Command_Code | No_Code then
            return Channel'Pos (From) + 1;
         end if;
         pragma Loop_Invariant
           (for all Earlier in Channel =>
              (if Earlier <= From
               then Codes (Earlier) in Command_Code | No_Code));
      end loop;
      return 0;
   end First_Unknown_Command;

   function First_Unknown_Sensor (Codes : Channel_Codes)
                                 return Unknown_Count is
   begin
      for From in Channel loop
         if Codes (From) not in Sensor_Code | No_Code then
            return Channel'Pos (From) + 1;
         end if;
         pragma Loop_Invariant
           (for all Earlier in Channel =>
              (if Earlier <= From
               then Codes (Earlier) in Sensor_Code | No_Code));
      end loop;
      return 0;
   end First_Unknown_Sensor;

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
