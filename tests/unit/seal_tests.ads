--  SPDX-License-Identifier: Apache-2.0

--  SEC-1 to SEC-5: the sealed link.

with AUnit.Test_Suites;

package Seal_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Seal_Tests;
