--  SPDX-License-Identifier: Apache-2.0

--  EXT-1, INI-6, TST-4: the log task and its words in CORE.

with AUnit.Test_Suites;

package LOG_Task_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end LOG_Task_Tests;
