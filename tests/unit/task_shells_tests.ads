--  SPDX-License-Identifier: Apache-2.0

--  The bodies of the tasks send, write and report what their decisions say
--  (SET-2): the decisions are proved, the bodies are not. Each test has
--  inputs that all differ, so that a variable in another's place, or one that
--  is forgotten, fails it.

with AUnit.Test_Suites;

package Task_Shells_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Task_Shells_Tests;
