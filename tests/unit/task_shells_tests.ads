--  SPDX-License-Identifier: Apache-2.0

--  The bodies of the tasks send, write and report the results of their
--  decisions (SET-2). The decisions are proved; the bodies are not. In each
--  test all inputs differ, so a missing variable, or one in place of another,
--  fails it.

with AUnit.Test_Suites;

package Task_Shells_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Task_Shells_Tests;
