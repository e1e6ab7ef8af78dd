--  SPDX-License-Identifier: Apache-2.0

--  Every so-maniest test, so that several processes can share all of them.

with AUnit.Test_Filters;
with AUnit.Tests;

package Test_Shares is

   type Share is new AUnit.Test_Filters.Test_Filter with record
      Of_Shares : Positive;
      Number    : Positive;   --  1 .. Of_Shares
   end record;

   --  Asked once of each test, in the order in which they run.
   overriding function Is_Active
     (Filter : Share;
      T      : AUnit.Tests.Test'Class) return Boolean;

end Test_Shares;
