--  SPDX-License-Identifier: Apache-2.0

--  RTP-10: outputs for which no task waits.

with AUnit.Test_Suites;

package Output_Buffers_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Output_Buffers_Tests;
