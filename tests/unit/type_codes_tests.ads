--  SPDX-License-Identifier: Apache-2.0

--  EXT-2: data goes to the item of its type code, and configurations from the
--  ground are taken whole or not at all.

with AUnit.Test_Suites;

package Type_Codes_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Type_Codes_Tests;
