--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Self_Test with SPARK_Mode is

   procedure Times_X_Is_Multiplication (Value : Long) is null;

   --  Multiplication by x keeps different remainders different.
   procedure Times_X_Distinguishes (Left, Right : Long)
   with
     Global => null,
     Pre    => Left /= Right,
     Post   => Times_X (Left) /= Times_X (Right);

   procedure Times_X_Distinguishes (Left, Right : Long) is null;

   --  No value but 0 equals its product by x, and the product of a sum is the
   --  sum of the products.
   procedure Times_X_Changes (Start, Left, Right : Long)
   with
     Global => null,
     Pre    => Left /= Right,
     Post   =>
       (Times_X (Start xor Left) xor Times_X (Start xor Right))
       /= (Left xor Right);

   procedure Times_X_Changes (Start, Left, Right : Long) is null;

   procedure Step_Distinguishes (Left, Right : Sum; Data : Long) is
   begin
      if Left.Remainder /= Right.Remainder then
         Times_X_Distinguishes (Left.Remainder, Right.Remainder);
      else
         pragma Assert
           ((Left.Parity xor Data) /= (Right.Parity xor Data));
      end if;
   end Step_Distinguishes;

   procedure Two_Steps_Distinguish
     (Start                            : Sum;
      Left_1, Left_2, Right_1, Right_2 : Long)
   is
      After_Left  : constant Sum := Next (Next (Start, Left_1), Left_2);
      After_Right : constant Sum := Next (Next (Start, Right_1), Right_2);
   begin
      if Left_1 = Right_1 then
         pragma Assert (After_Left.Parity /= After_Right.Parity);
      elsif (Left_1 xor Left_2) /= (Right_1 xor Right_2) then
         pragma Assert
           (After_Left.Parity = (Start.Parity xor (Left_1 xor Left_2)));
         pragma Assert
           (After_Right.Parity = (Start.Parity xor (Right_1 xor Right_2)));
      else
         pragma Assert ((Left_1 xor Right_1) = (Left_2 xor Right_2));
         Times_X_Changes (Times_X (Start.Remainder), Left_1, Right_1);
         pragma Assert (After_Left.Remainder /= After_Right.Remainder);
      end if;
   end Two_Steps_Distinguish;

   procedure Same_Longs_Same_Sum
     (Left, Right : Image;
      Length      : Image_Length)
   is
   begin
      if Length > 0 then
         Same_Longs_Same_Sum (Left, Right, Length - 1);
      end if;
   end Same_Longs_Same_Sum;

   procedure Two_Wrong_Neighbours_Are_Detected
     (Right, Spoilt : Image;
      Wrong         : Long_Address;
      Length        : Image_Length)
   is
   begin
      if Image_Length (Wrong) = Length - 2 then
         Same_Longs_Same_Sum (Right, Spoilt, Length - 2);
         Two_Steps_Distinguish
           (Sum_After (Right, Length - 2),
            Right (Wrong), Right (Wrong + 1),
            Spoilt (Wrong), Spoilt (Wrong + 1));
      else
         Two_Wrong_Neighbours_Are_Detected (Right, Spoilt, Wrong, Length - 1);
         Step_Distinguishes
           (Sum_After (Right, Length - 1),
            Sum_After (Spoilt, Length - 1),
            Right (Long_Address (Length - 1)));
      end if;
   end Two_Wrong_Neighbours_Are_Detected;

   --  A value divided by x + 1, times x + 1.
   procedure Division_Is_Right (Value : Long)
   with
     Global => null,
     Post   => (Times_X (Divided (Value)) xor Divided (Value)) = Value;

   procedure Division_Is_Right (Value : Long) is
      Sums : constant Long := Running_Sums (Value);
   begin
      pragma Assert ((Sums xor Shift_Left (Sums, 1)) = Value);
   end Division_Is_Right;

   procedure Times_X_Of_Sum (Left, Right : Long)
   with
     Global => null,
     Post   =>
       Times_X (Left xor Right) = (Times_X (Left) xor Times_X (Right));

   procedure Times_X_Of_Sum (Left, Right : Long) is null;

   procedure Kept_Longs_Make_Good (Before : Sum) is
      Parity : constant Long := Before.Parity;
      Twice  : constant Long := Times_X (Times_X (Before.Remainder));
      First  : constant Long := Divided (Twice xor Parity);
   begin
      Division_Is_Right (Twice xor Parity);
      pragma Assert (Kept_Long (Before, 0) = First);
      pragma Assert (Kept_Long (Before, 1) = (First xor Parity));
      Times_X_Of_Sum (Times_X (Before.Remainder), First);
   end Kept_Longs_Make_Good;

   procedure Image_With_Its_Sum_Is_Good (Item : Image) is
      Length : constant Image_Length := Item'Length;
      Start  : constant Sum := Sum_After (Item, Length - 2);
   begin
      pragma Assert
        (Item (Long_Address (Length - 2)) = Kept_Long (Start, 0));
      pragma Assert
        (Item (Long_Address (Length - 1)) = Kept_Long (Start, 1));
      pragma Assert
        (Sum_After (Item, Length - 1) = Next (Start, Kept_Long (Start, 0)));
      Kept_Longs_Make_Good (Start);
   end Image_With_Its_Sum_Is_Good;

   procedure Check_Determines_The_Image
     (Item    : in out Check;
      Source  : Checked_Image;
      Outcome : out Outcome_Kind)
   is
      Was : constant Check := Item;
   begin
      Take_Long (Item, Source (Item.Position), Outcome);
      pragma Assert
        (Next (Was.Sums, Source (Was.Position)) =
           Sum_After (Source, Image_Length (Was.Position) + 1));
   end Check_Determines_The_Image;

end Theorems.Self_Test;
