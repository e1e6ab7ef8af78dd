--  SPDX-License-Identifier: Apache-2.0

--  EXT-3, EXT-5: the control laws, the loss of the link, the sensors' checks.

with AUnit.Test_Suites;

package Laws_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Laws_Tests;
