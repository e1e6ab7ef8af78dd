--  SPDX-License-Identifier: Apache-2.0

package body Explore is

   Now : Block_Lengths := Real_Lengths;

   Told : Round_Trip_Time := 0;

   procedure Set_Lengths (Lengths : Block_Lengths) is
   begin
      Now := Lengths;
   end Set_Lengths;

   function Length_Of (Sender : Station) return Block_Length is
     (Now (Sender));

   procedure Set_Round_Trip (Time : Round_Trip_Time) is
   begin
      Told := Time;
   end Set_Round_Trip;

   function Round_Trip return Round_Trip_Time is (Told);

end Explore;
