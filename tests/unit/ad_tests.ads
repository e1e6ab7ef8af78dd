--  SPDX-License-Identifier: Apache-2.0

--  ADI-1, AD-1, INI-5: the scan of the converter's channels, its interrupt
--  handler, and the task that sends it on.

with AUnit.Test_Suites;

package AD_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end AD_Tests;
