--  SPDX-License-Identifier: Apache-2.0

--  TST-1 to TST-4: the faults that the self-test finds, and the absence of
--  false alarms.

with AUnit.Test_Suites;

package Self_Test_Tests is

   --  Briefly omits the thousand starts.
   procedure Add_To
     (Suite : AUnit.Test_Suites.Access_Test_Suite; Briefly : Boolean);

end Self_Test_Tests;
