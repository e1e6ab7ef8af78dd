--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Self_Test with SPARK_Mode is

   procedure Step_Is_Polynomial_Division (Register : Sum) is null;

   --  Half a step keeps different registers different.
   procedure Half_A_Step_Distinguishes (Left, Right : Sum)
   with
     Global => null,
     Pre    => Left /= Right,
     Post   => Four_Bits_On (Left) /= Four_Bits_On (Right);

   procedure Half_A_Step_Distinguishes (Left, Right : Sum) is null;

   procedure Step_Distinguishes
     (Left, Right     : Sum;
      Data_1, Data_2 : Byte)
   is
      Left_In  : constant Sum := Left xor Sum (Data_1);
      Right_In : constant Sum := Right xor Sum (Data_2);
   begin
      pragma Assert (Left_In /= Right_In);
      Half_A_Step_Distinguishes (Left_In, Right_In);
      Half_A_Step_Distinguishes
        (Four_Bits_On (Left_In), Four_Bits_On (Right_In));
   end Step_Distinguishes;

   procedure Same_Bytes_Same_Register
     (Left, Right : Image;
      Length      : Image_Length)
   is
   begin
      if Length > 0 then
         Same_Bytes_Same_Register (Left, Right, Length - 1);
      end if;
   end Same_Bytes_Same_Register;

   procedure One_Wrong_Byte_Is_Detected
     (Right, Spoilt : Image;
      Wrong         : Byte_Address;
      Length        : Image_Length)
   is
   begin
      if Image_Length (Wrong) = Length - 1 then
         Same_Bytes_Same_Register (Right, Spoilt, Length - 1);
      else
         One_Wrong_Byte_Is_Detected (Right, Spoilt, Wrong, Length - 1);
      end if;
      Step_Distinguishes
        (Register_After (Right, Length - 1),
         Register_After (Spoilt, Length - 1),
         Right (Byte_Address (Length - 1)),
         Spoilt (Byte_Address (Length - 1)));
   end One_Wrong_Byte_Is_Detected;

   procedure Kept_Bytes_Make_Good (Register : Sum) is null;

   procedure Image_With_Its_Sum_Is_Good (Item : Image) is
      Length : constant Image_Length := Item'Length;
      Start  : constant Sum := Register_After (Item, Length - 4);
   begin
      pragma Assert
        (Item (Byte_Address (Length - 4)) = Kept_Byte (Start, 0));
      pragma Assert
        (Item (Byte_Address (Length - 3)) = Kept_Byte (Start, 1));
      pragma Assert
        (Item (Byte_Address (Length - 2)) = Kept_Byte (Start, 2));
      pragma Assert
        (Item (Byte_Address (Length - 1)) = Kept_Byte (Start, 3));
      pragma Assert
        (Register_After (Item, Length - 3) =
           Next (Start, Kept_Byte (Start, 0)));
      pragma Assert
        (Register_After (Item, Length - 2) =
           Next (Next (Start, Kept_Byte (Start, 0)), Kept_Byte (Start, 1)));
      pragma Assert
        (Register_After (Item, Length - 1) =
           Next (Next (Next
             (Start, Kept_Byte (Start, 0)), Kept_Byte (Start, 1)),
              Kept_Byte (Start, 2)));
      Kept_Bytes_Make_Good (Start);
   end Image_With_Its_Sum_Is_Good;

   procedure Check_Determines_The_Image
     (Item    : in out Check;
      Source  : Checked_Image;
      Outcome : out Outcome_Kind)
   is
      Was : constant Check := Item;
   begin
      Take_Byte (Item, Source (Item.Position), Outcome);
      pragma Assert
        (Next (Was.Register, Source (Was.Position)) =
           Register_After (Source, Image_Length (Was.Position) + 1));
   end Check_Determines_The_Image;

end Theorems.Self_Test;
