--  SPDX-License-Identifier: Apache-2.0

--  FRM-2 to FRM-4: the times at which the tasks of a node run.

with AUnit.Test_Suites;

package Executives_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Executives_Tests;
