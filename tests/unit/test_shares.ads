--  SPDX-License-Identifier: Apache-2.0

--  Selects every n-th test, so that several processes can share all tests.

with AUnit.Test_Filters;
with AUnit.Tests;

package Test_Shares is

   type Share is new AUnit.Test_Filters.Test_Filter with record
      Of_Shares : Positive;
      Number    : Positive;   --  1 .. Of_Shares
   end record;

   --  Called once for each test, in the order in which they run.
   overriding function Is_Active
     (Filter : Share;
      T      : AUnit.Tests.Test'Class) return Boolean;

end Test_Shares;
