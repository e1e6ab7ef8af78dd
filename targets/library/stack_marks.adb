--  SPDX-License-Identifier: Apache-2.0

with System.Storage_Elements; use System.Storage_Elements;

package body Stack_Marks is

   After : Unsigned_32
   with Import, External_Name => "urv_stack_top";

   function Used return Unsigned_32 is
      Most  : constant := 16#4000#;
      Words : array (Unsigned_32 range 0 .. Most / 4 - 1) of Unsigned_32
      with Import, Volatile_Components, External_Name => "urv_stack_bottom";
      Size       : constant Unsigned_32 :=
        Unsigned_32 (After'Address - Words'Address);
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
