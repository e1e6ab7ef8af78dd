--  SPDX-License-Identifier: Apache-2.0

--  LNK-3, D-5: the board sends a data message, character by character.

with AUnit.Test_Suites;

package Senders_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Senders_Tests;
