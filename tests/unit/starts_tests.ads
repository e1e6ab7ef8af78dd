--  SPDX-License-Identifier: Apache-2.0

--  INI-1 to INI-8, TST-4, KRN-5, KRN-6, EXT-4: the start of a node, and the
--  data that each kind of start clears and keeps.

with AUnit.Test_Suites;

package Starts_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Starts_Tests;
