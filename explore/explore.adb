--  SPDX-License-Identifier: Apache-2.0

package body Explore is

   Now : Block_Lengths := Real_Lengths;

   procedure Set_Lengths (Lengths : Block_Lengths) is
   begin
      Now := Lengths;
   end Set_Lengths;

   function Length_Of (Sender : Station) return Block_Length is
     (Now (Sender));

end Explore;
