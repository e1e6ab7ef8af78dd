--  SPDX-License-Identifier: Apache-2.0

--  The self-test's checksum finds every program image with one wrong byte, and
--  accepts every image with its right sum (TST-1, TST-3). This holds for all
--  images of any length, and for the check in flight of 64 KiB in slices of
--  any size. Images with several wrong bytes may pass by chance, about once in
--  four billion; see URVOS.Image_Sums.

with URVOS;            use URVOS;
with URVOS.Image_Sums; use URVOS.Image_Sums;
with URVOS.Memories;   use URVOS.Memories;
with URVOS.ROM_Checks;

package Theorems.Self_Test with Pure, SPARK_Mode, Ghost is

   --  One step of the division by the polynomial, which the table computes.
   function Shifted (Register : Sum) return Sum is
     (if (Register and 1) /= 0
      then Shift_Right (Register, 1) xor 16#82F6_3B78#
      else Shift_Right (Register, 1));

   procedure Step_Is_Polynomial_Division (Register : Sum)
   with
     Global => null,
     Post   =>
       Four_Bits_On (Register) =
         Shifted (Shifted (Shifted (Shifted (Register))));

   --  Different registers remain different after the same byte, and the same
   --  register becomes different after different bytes.
   procedure Step_Distinguishes
     (Left, Right     : Sum;
      Data_1, Data_2 : Byte)
   with
     Global => null,
     Pre    => (Left = Right) /= (Data_1 = Data_2),
     Post   => Next (Left, Data_1) /= Next (Right, Data_2);

   --  The register depends only on the bytes taken.
   procedure Same_Bytes_Same_Register
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
       Register_After (Left, Length) = Register_After (Right, Length);

   --  An image with exactly one wrong byte, in any bits, has another register
   --  at the end.
   procedure One_Wrong_Byte_Is_Detected
     (Right, Spoilt : Image;
      Wrong         : Byte_Address;
      Length        : Image_Length)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Length),
     Pre                =>
       Right'First = 0
       and then Spoilt'First = 0
       and then Right'Last = Spoilt'Last
       and then Length <= Right'Length
       and then Image_Length (Wrong) < Length
       and then Right (Wrong) /= Spoilt (Wrong)
       and then (for all I in Right'Range =>
                   (if I /= Wrong then Right (I) = Spoilt (I))),
     Post               =>
       Register_After (Right, Length) /= Register_After (Spoilt, Length);

   --  After its own four bytes, any register is that of a good image.
   procedure Kept_Bytes_Make_Good (Register : Sum)
   with
     Global => null,
     Post   =>
       Next (Next (Next (Next
         (Register, Kept_Byte (Register, 0)), Kept_Byte (Register, 1)),
          Kept_Byte (Register, 2)), Kept_Byte (Register, 3)) = Good_Image;

   --  An image with its sum in its last four bytes is a good one.
   procedure Image_With_Its_Sum_Is_Good (Item : Image)
   with
     Global => null,
     Pre    =>
       Item'First = 0
       and then Item'Last >= 3
       and then (for all Place in Sum_Place =>
                   Item (Item'Last - 3 + Byte_Address (Place)) =
                     Kept_Byte
                       (Register_After (Item, Item'Length - 4), Place)),
     Post   => Register_After (Item, Item'Length) = Good_Image;

   --  A check of 64 KiB finds the state of the image when it continues from
   --  any byte to the end of the pass. The number of slices does not matter: a
   --  slice only takes some bytes

   package Checks is new ROM_Checks (Last => 16#FFFF#);
   use Checks;

   subtype Checked_Image is Image (0 .. 16#FFFF#);

   --  The check has taken the bytes of the image before its position.
   function Is_Within (Item : Check; Source : Checked_Image) return Boolean
   is
     (Item.Register = Register_After (Source, Image_Length (Item.Position)));

   --  This holds at the first byte of any image. Each further byte keeps it
   --  so, and the last byte gives the outcome for the image.
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
              (Register_After (Source, Source'Length) = Good_Image)
            and then (Outcome = Found_Bad) =
              (Register_After (Source, Source'Length) /= Good_Image));

end Theorems.Self_Test;
