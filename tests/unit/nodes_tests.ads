--  SPDX-License-Identifier: Apache-2.0

--  SET-1, SET-2, INI-3 to INI-8: both nodes with their real wiring, between
--  the hardware sides of their boards.

with AUnit.Test_Suites;

package Nodes_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Nodes_Tests;
