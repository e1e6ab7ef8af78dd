--  SPDX-License-Identifier: Apache-2.0

--  KRN-1 to KRN-4, FRM-4: the choice of the running task.

with AUnit.Test_Suites;

package Schedulers_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Schedulers_Tests;
