--  SPDX-License-Identifier: Apache-2.0

package body Stack_Marks is

   function Used return Unsigned_32 is
      Size  : constant := 16#4000#;
      Words : array (Unsigned_32 range 0 .. Size / 4 - 1) of Unsigned_32
      with Import, Volatile_Components, External_Name => "urv_stack_bottom";
      Free_Words : Unsigned_32 := 0;
   begin
      while Free_Words < Size / 4
        and then Words (Free_Words) = 16#5AA5_5AA5#
      loop
         Free_Words := Free_Words + 1;
      end loop;
      return Size - 4 * Free_Words;
   end Used;

end Stack_Marks;
