--  SPDX-License-Identifier: Apache-2.0

--  MBX-3, MBX-5: RECV with a wait, and the end of every wait.

with AUnit.Test_Suites;

package Receive_Calls_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Receive_Calls_Tests;
