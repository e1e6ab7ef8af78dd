--  SPDX-License-Identifier: Apache-2.0

--  EXT-3, MBX-2: the LAW task's reports and their times.

with AUnit.Test_Suites;

package LAW_Task_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end LAW_Task_Tests;
