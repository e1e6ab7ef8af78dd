--  SPDX-License-Identifier: Apache-2.0

--  LNK-2 to LNK-10: two boards and the line between them. The line can be cut,
--  and its characters can be changed, lost, doubled and invented.

with AUnit.Test_Suites;

package Link_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Link_Tests;
