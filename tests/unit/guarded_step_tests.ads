--  SPDX-License-Identifier: Apache-2.0

--  KRN-6: what a partition makes of an exception in a task's step.

with AUnit.Test_Suites;

package Guarded_Step_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Guarded_Step_Tests;
