--  SPDX-License-Identifier: Apache-2.0

package body Test_Shares is

   Asked : Natural := 0;

   overriding function Is_Active
     (Filter : Share;
      T      : AUnit.Tests.Test'Class) return Boolean
   is
      pragma Unreferenced (T);
      Place : constant Natural := Asked mod Filter.Of_Shares;
   begin
      Asked := Asked + 1;
      return Place + 1 = Filter.Number;
   end Is_Active;

end Test_Shares;
