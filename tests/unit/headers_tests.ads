--  SPDX-License-Identifier: Apache-2.0

--  LNK-3, D-6: the first byte of a message.

with AUnit.Test_Suites;

package Headers_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Headers_Tests;
