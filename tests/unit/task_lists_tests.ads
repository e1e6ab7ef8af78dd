--  SPDX-License-Identifier: Apache-2.0

--  Tests of the nodes' lists of tasks and of what follows from them.

with AUnit.Test_Suites;

package Task_Lists_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Task_Lists_Tests;
