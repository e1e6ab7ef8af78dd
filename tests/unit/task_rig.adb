--  SPDX-License-Identifier: Apache-2.0

with Expectations; use Expectations;

package body Task_Rig is

   procedure Expect_Errors
     (What     : String;
      Log      : in out URV.Shared_Errors.Shared_Log;
      Expected : Error_List;
      Detail   : Word := 0)
   is
      Found  : constant Error_Log := Log.Contents;
      Wanted : array (Error_Kind) of Count := (others => 0);
   begin
      for Kind of Expected loop
         Wanted (Kind) := Wanted (Kind) + 1;
      end loop;
      for Kind in Error_Kind loop
         Expect
           (What & ", errors " & Kind'Image,
            Logs.History_Of (Found, Kind).Occurrences, Wanted (Kind));
         Expect
           (What & ", detail of " & Kind'Image,
            Logs.History_Of (Found, Kind).Last_Detail,
            (if Expected'Length > 0 and then Kind = Expected (Expected'Last)
             then Detail else 0));
      end loop;
      Log.Clear;
   end Expect_Errors;

   function Uplink_Of (Mark : Word) return Uplink_Buffer is
   begin
      return Result : Uplink_Buffer do
         for Item in Result'Range loop
            Result (Item) := Mark + Word (Uplink_Item'Pos (Item));
         end loop;
         Result (Error_Status) := 0;
      end return;
   end Uplink_Of;

   function Downlink_Of (Mark : Word) return Downlink_Buffer is
   begin
      return Result : Downlink_Buffer do
         for Item in Result'Range loop
            Result (Item) := Mark + Word (Downlink_Item'Pos (Item));
         end loop;
         Result (Error_Status) := 0;
      end return;
   end Downlink_Of;

   function Image_Of (Mark : Word; Error : Word) return AD_Image is
   begin
      return Result : AD_Image do
         for Number in Channel loop
            Result.Words (Number) := Mark + Word (Number);
         end loop;
         Result.Error_Status := Error;
      end return;
   end Image_Of;

   procedure Expect_Buffer
     (What : String; Actual, Expected : Uplink_Buffer) is
   begin
      for Item in Uplink_Item loop
         Expect (What & ", " & Item'Image, Actual (Item), Expected (Item));
      end loop;
   end Expect_Buffer;

   procedure Expect_Buffer
     (What : String; Actual, Expected : Downlink_Buffer) is
   begin
      for Item in Downlink_Item loop
         Expect (What & ", " & Item'Image, Actual (Item), Expected (Item));
      end loop;
   end Expect_Buffer;

end Task_Rig;
