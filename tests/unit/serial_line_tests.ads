--  SPDX-License-Identifier: Apache-2.0

--  RTP-1: a serial device's report of a character.

with AUnit.Test_Suites;

package Serial_Line_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Serial_Line_Tests;
