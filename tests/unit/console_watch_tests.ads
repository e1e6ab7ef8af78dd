--  SPDX-License-Identifier: Apache-2.0

--  SAF-10: the ground converter's input for a silent console.

with AUnit.Test_Suites;

package Console_Watch_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Console_Watch_Tests;
