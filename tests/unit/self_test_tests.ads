--  SPDX-License-Identifier: Apache-2.0

--  TST-1 to TST-4: what the self-test finds, and that it finds nothing where
--  nothing is wrong.

with AUnit.Test_Suites;

package Self_Test_Tests is

   --  Briefly: without the thousand starts.
   procedure Add_To
     (Suite : AUnit.Test_Suites.Access_Test_Suite; Briefly : Boolean);

end Self_Test_Tests;
