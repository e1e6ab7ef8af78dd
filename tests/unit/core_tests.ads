--  SPDX-License-Identifier: Apache-2.0

--  COR-1, INI-6, INI-7, BUF-4: CORE memory and the task that writes it.

with AUnit.Test_Suites;

package CORE_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end CORE_Tests;
