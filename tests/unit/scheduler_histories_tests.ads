--  SPDX-License-Identifier: Apache-2.0

--  KRN-1 to KRN-4, FRM-4: histories of calls, with the state after each call
--  as the report's sections 3.2 and 3.3 define it. They were written by hand.

with AUnit.Test_Suites;

package Scheduler_Histories_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Scheduler_Histories_Tests;
