--  SPDX-License-Identifier: Apache-2.0

--  EXT-1: the error log, and the shell that guards a node's log.

with AUnit.Test_Suites;

package Error_Log_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Error_Log_Tests;
