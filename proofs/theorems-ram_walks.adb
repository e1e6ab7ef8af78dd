--  SPDX-License-Identifier: Apache-2.0

package body Theorems.RAM_Walks with SPARK_Mode is

   procedure Cells_Follow_Each_Other
     (Number : Cell_Number;
      Steps  : Cell_Count;
      Parts  : Part_Sizes) is
   begin
      if Steps > 0 then
         Cells_Follow_Each_Other (Number, Steps - 1, Parts);
      end if;
   end Cells_Follow_Each_Other;

   procedure Every_Cell_Comes
     (Number, Wanted : Cell_Number;
      Parts          : Part_Sizes) is
   begin
      Cells_Follow_Each_Other
        (Number, Steps_To (Number, Wanted, Parts), Parts);
   end Every_Cell_Comes;

   procedure Each_Place_Has_One_Number
     (Item   : Place;
      Number : Cell_Number;
      Parts  : Part_Sizes)
   is null;

end Theorems.RAM_Walks;
