--  SPDX-License-Identifier: Apache-2.0

--  LNK-3 to LNK-5: one board receives, character by character.

with AUnit.Test_Suites;

package Receivers_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Receivers_Tests;
