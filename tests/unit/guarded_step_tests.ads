--  SPDX-License-Identifier: Apache-2.0

--  KRN-6: the partition's reaction to an exception in a task's step.

with AUnit.Test_Suites;

package Guarded_Step_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Guarded_Step_Tests;
