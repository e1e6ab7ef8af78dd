--  SPDX-License-Identifier: Apache-2.0

--  RTP-7: the peer counts as heard when its blocks are taken.

with AUnit.Test_Suites;

package Peer_Watch_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Peer_Watch_Tests;
