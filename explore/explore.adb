--  SPDX-License-Identifier: Apache-2.0

package body Explore is

   function Byte_Of (Sum : Byte) return Byte is
   begin
      for Value in Byte loop
         if Sum_Of (Value) = Sum then
            return Value;
         end if;
      end loop;
      raise Program_Error;
   end Byte_Of;

   function Unlike_All return Byte is
   begin
      for Value in Byte loop
         if not Is_Sent (Value) then
            return Value;
         end if;
      end loop;
      raise Program_Error;
   end Unlike_All;

end Explore;
