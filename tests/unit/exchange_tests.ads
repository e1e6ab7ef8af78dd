--  SPDX-License-Identifier: Apache-2.0

--  MDI-1, MDO-1, GDI-1, GDO-1, D-11: the tasks between a node's variables.

with AUnit.Test_Suites;

package Exchange_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Exchange_Tests;
