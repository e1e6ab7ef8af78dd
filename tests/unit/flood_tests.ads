--  SPDX-License-Identifier: Apache-2.0

--  RTP-3: floods.

with AUnit.Test_Suites;

package Flood_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Flood_Tests;
