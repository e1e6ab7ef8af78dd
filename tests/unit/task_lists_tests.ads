--  SPDX-License-Identifier: Apache-2.0

--  The nodes' lists of tasks, and the headers and trees made of them.

with AUnit.Test_Suites;

package Task_Lists_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Task_Lists_Tests;
