--  SPDX-License-Identifier: Apache-2.0

--  The self-test's checksum finds every program image with one wrong long or
--  two wrong neighbours, and accepts every image with its right sum (TST-1,
--  TST-3). This holds for all images of any length, and for the check in
--  flight of 64 KiB in slices of any size. URVOS.Image_Sums lists what else it
--  finds.

with URVOS;            use URVOS;
with URVOS.Image_Sums; use URVOS.Image_Sums;
with URVOS.Memories;   use URVOS.Memories;
with URVOS.ROM_Checks;

package Theorems.Self_Test with Pure, SPARK_Mode, Ghost is

   type Wide is mod 2 ** 64;

   --  Times_X is the multiplication by x modulo the polynomial
   --  x^32 + x^7 + x^6 + x^2 + 1: the product differs by the polynomial or by
   --  nothing.
   procedure Times_X_Is_Multiplication (Value : Long)
   with
     Global => null,
     Post   =>
       (Wide (Times_X (Value)) xor 2 * Wide (Value)) =
         (if Value < 2 ** 31 then 0 else 16#1_0000_00C5#);

   --  Different sums remain different after the same long.
   procedure Step_Distinguishes (Left, Right : Sum; Data : Long)
   with
     Global => null,
     Pre    => Left /= Right,
     Post   => Next (Left, Data) /= Next (Right, Data);

   --  Two steps from the same sums, with any difference in their longs.
   procedure Two_Steps_Distinguish
     (Start                            : Sum;
      Left_1, Left_2, Right_1, Right_2 : Long)
   with
     Global => null,
     Pre    => Left_1 /= Right_1 or else Left_2 /= Right_2,
     Post   =>
       Next (Next (Start, Left_1), Left_2) /=
         Next (Next (Start, Right_1), Right_2);

   --  The sums depend only on the longs taken.
   procedure Same_Longs_Same_Sum
     (Left, Right : Image;
      Length      : Image_Length)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Length),
     Pre                =>
       Left'First = 0
       and then Right'First = 0
       and then Length <= Left'Length
       and then Length <= Right'Length
       and then (for all I in Left'Range =>
                   (if Image_Length (I) < Length then Left (I) = Right (I))),
     Post               =>
       Sum_After (Left, Length) = Sum_After (Right, Length);

   --  An image with wrong bits in two neighbouring longs, Wrong and the next
   --  one, and nowhere else, has other sums at the end.
   procedure Two_Wrong_Neighbours_Are_Detected
     (Right, Spoilt : Image;
      Wrong         : Long_Address;
      Length        : Image_Length)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Length),
     Pre                =>
       Right'First = 0
       and then Spoilt'First = 0
       and then Right'Last = Spoilt'Last
       and then Length <= Right'Length
       and then Image_Length (Wrong) + 1 < Length
       and then (Right (Wrong) /= Spoilt (Wrong)
                 or else Right (Wrong + 1) /= Spoilt (Wrong + 1))
       and then (for all I in Right'Range =>
                   (if I not in Wrong | Wrong + 1
                    then Right (I) = Spoilt (I))),
     Post               =>
       Sum_After (Right, Length) /= Sum_After (Spoilt, Length);

   --  After its own two longs, any sum is that of a good image.
   procedure Kept_Longs_Make_Good (Before : Sum)
   with
     Global => null,
     Post   =>
       Next (Next (Before, Kept_Long (Before, 0)), Kept_Long (Before, 1))
       = Good_Image;

   --  An image with its sum in its last two longs is a good one.
   procedure Image_With_Its_Sum_Is_Good (Item : Image)
   with
     Global => null,
     Pre    =>
       Item'First = 0
       and then Item'Last >= 1
       and then (for all Place in Kept_Place =>
                   Item (Item'Last - 1 + Long_Address (Place)) =
                     Kept_Long
                       (Sum_After (Item, Item'Length - 2), Place)),
     Post   => Sum_After (Item, Item'Length) = Good_Image;

   --  A check of 64 KiB finds the state of the image when it continues from
   --  any long to the end of the pass. The number of slices does not matter: a
   --  slice only takes some longs

   package Checks is new ROM_Checks (Last => 16#3FFF#);
   use Checks;

   subtype Checked_Image is Image (0 .. 16#3FFF#);

   --  The check has taken the longs of the image before its position.
   function Is_Within (Item : Check; Source : Checked_Image) return Boolean
   is
     (Item.Sums = Sum_After (Source, Image_Length (Item.Position)));

   --  This holds at the first long of any image. Each further long keeps it
   --  so, and the last long gives the outcome for the image.
   procedure Check_Determines_The_Image
     (Item    : in out Check;
      Source  : Checked_Image;
      Outcome : out Outcome_Kind)
   with
     Global => null,
     Pre    => Is_Within (Item, Source),
     Post   =>
       Is_Within (Item, Source)
       and then Is_Within (New_Check, Source)
       and then
         (if Item'Old.Position < Place'Last
          then Outcome = Under_Way
            and then Item.Position = Item'Old.Position + 1
          else Item.Position = 0
            and then (Outcome = Found_Good) =
              (Sum_After (Source, Source'Length) = Good_Image)
            and then (Outcome = Found_Bad) =
              (Sum_After (Source, Source'Length) /= Good_Image));

end Theorems.Self_Test;
