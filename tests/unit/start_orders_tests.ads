--  SPDX-License-Identifier: Apache-2.0

--  EXT-4, INI-2, KRN-5: the common start of a node's processors.

with AUnit.Test_Suites;

package Start_Orders_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Start_Orders_Tests;
