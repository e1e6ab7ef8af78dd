--  SPDX-License-Identifier: Apache-2.0

--  Tests of what the nodes find out about themselves in flight: the check of
--  the program memory, tasks that come late.

with AUnit.Test_Suites;

package In_Flight_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end In_Flight_Tests;
