--  SPDX-License-Identifier: Apache-2.0

--  KRN-1 to KRN-6, EXT-4: a node of Ada tasks, on the machine's clock.

with AUnit.Test_Suites;

package Real_Time_Nodes_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Real_Time_Nodes_Tests;
