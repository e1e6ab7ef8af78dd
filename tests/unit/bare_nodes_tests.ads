--  SPDX-License-Identifier: Apache-2.0

--  BRD-1: a node on a bare machine.

with AUnit.Test_Suites;

package Bare_Nodes_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Bare_Nodes_Tests;
