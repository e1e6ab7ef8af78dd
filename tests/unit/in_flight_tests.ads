--  SPDX-License-Identifier: Apache-2.0

--  The nodes' own checks in flight: the program memory and late tasks.

with AUnit.Test_Suites;

package In_Flight_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end In_Flight_Tests;
