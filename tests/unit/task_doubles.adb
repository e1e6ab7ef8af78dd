with Expectations; use Expectations;

package body Task_Doubles is

   procedure Clear is
   begin
      Status := 0;
      Words.Clear;
      Image.Clear;
      Input_Up.Clear;
      Input_Down.Clear;
      Uplink.Clear;
      Downlink.Clear;
      Output_Up.Clear;
      Output_Down.Clear;
      Commands.Clear;
      Errors := (others => 0);
      Last_Detail := 0;
   end Clear;

   procedure Read_Status (Bits : out Word) is
   begin
      Bits := Status;
   end Read_Status;

   procedure Report (Error : Error_Kind; Detail : Word) is
   begin
      Errors (Error) := Errors (Error) + 1;
      Last_Detail := Detail;
      if Error not in AD_No_Scan | AD_Unexpected_Interrupt | Input_Out_Of_Range
      then
         Expect ("detail of " & Error'Image, Detail, 0);
      end if;
   end Report;

   procedure Expect_Errors
     (What     : String;
      Expected : Error_List;
      Detail   : Word := 0)
   is
      Wanted : Error_Counts := (others => 0);
   begin
      for Kind of Expected loop
         Wanted (Kind) := Wanted (Kind) + 1;
      end loop;
      for Kind in Error_Kind loop
         Expect
           (What & ", errors " & Kind'Image, Errors (Kind), Wanted (Kind));
      end loop;
      Expect (What & ", detail", Last_Detail, Detail);
      Errors := (others => 0);
      Last_Detail := 0;
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

end Task_Doubles;
