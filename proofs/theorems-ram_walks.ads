--  SPDX-License-Identifier: Apache-2.0

--  The march in flight comes to every cell of the RAM, and to each once in a
--  pass (TST-5).

with URVOS.RAM_Walks; use URVOS.RAM_Walks;

package Theorems.RAM_Walks with Pure, SPARK_Mode, Ghost is

   --  The cell that is next after this number of tested cells.
   function Cell_After
     (Number : Cell_Number;
      Steps  : Cell_Count;
      Parts  : Part_Sizes) return Cell_Number
   is
     (if Steps = 0 then Number
      else Next_After (Cell_After (Number, Steps - 1, Parts), Parts))
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Steps),
     Pre                => Number <= Last_Cell (Parts),
     Post               => Cell_After'Result <= Last_Cell (Parts);

   --  Within a pass the numbers follow each other, and the first one follows
   --  the last one.
   procedure Cells_Follow_Each_Other
     (Number : Cell_Number;
      Steps  : Cell_Count;
      Parts  : Part_Sizes)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Steps),
     Pre                =>
       Number <= Last_Cell (Parts) and then Steps <= Last_Cell (Parts),
     Post               =>
       Cell_After (Number, Steps, Parts) =
         (if Steps <= Last_Cell (Parts) - Number then Number + Steps
          else Steps - (Last_Cell (Parts) - Number) - 1);

   --  From any cell the march comes to any other one, in fewer steps than
   --  there are cells.

   function Steps_To
     (Number, Wanted : Cell_Number;
      Parts          : Part_Sizes) return Cell_Count
   is
     (if Wanted >= Number then Wanted - Number
      else Last_Cell (Parts) - Number + Wanted + 1)
   with
     Global => null,
     Pre    =>
       Number <= Last_Cell (Parts) and then Wanted <= Last_Cell (Parts),
     Post   => Steps_To'Result <= Last_Cell (Parts);

   procedure Every_Cell_Comes
     (Number, Wanted : Cell_Number;
      Parts          : Part_Sizes)
   with
     Global => null,
     Pre    =>
       Number <= Last_Cell (Parts) and then Wanted <= Last_Cell (Parts),
     Post   =>
       Cell_After (Number, Steps_To (Number, Wanted, Parts), Parts) = Wanted;

   --  Each place of both parts has one number.

   function Number_Of (Item : Place; Parts : Part_Sizes) return Cell_Number
   is
     (case Item.Part is
         when Scratchpad => Item.Cell,
         when Variables  => Parts (Scratchpad) + Item.Cell)
   with
     Global => null,
     Pre    => Item.Cell < Parts (Item.Part);

   procedure Each_Place_Has_One_Number
     (Item   : Place;
      Number : Cell_Number;
      Parts  : Part_Sizes)
   with
     Global => null,
     Pre    =>
       Item.Cell < Parts (Item.Part) and then Number <= Last_Cell (Parts),
     Post   =>
       Number_Of (Item, Parts) <= Last_Cell (Parts)
       and then
         (Place_Of (Number, Parts) = Item) =
           (Number = Number_Of (Item, Parts));

end Theorems.RAM_Walks;
