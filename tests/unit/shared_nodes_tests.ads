--  SPDX-License-Identifier: Apache-2.0

--  INI-1, KRN-6, FRM-4: starts that are requested while tasks run.

with AUnit.Test_Suites;

package Shared_Nodes_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Shared_Nodes_Tests;
