--  SPDX-License-Identifier: Apache-2.0

--  The use of the stack. The start-up code fills it with marks.

with Interfaces; use Interfaces;

package Stack_Marks is

   --  The bytes that have been used, at most.
   function Used return Unsigned_32;

end Stack_Marks;
