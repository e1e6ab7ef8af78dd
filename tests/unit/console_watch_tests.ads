--  SPDX-License-Identifier: Apache-2.0

--  SAF-10: what the ground's converter gives for a silent console.

with AUnit.Test_Suites;

package Console_Watch_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Console_Watch_Tests;
