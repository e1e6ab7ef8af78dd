--  SPDX-License-Identifier: Apache-2.0

--  D-7: the checksum's definition, and the errors that change it.

with AUnit.Test_Suites;

package Checksum_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Checksum_Tests;
