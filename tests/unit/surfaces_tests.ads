--  SPDX-License-Identifier: Apache-2.0

--  EXT-6: the monitor reports a failed surface, and the others make up for it.

with AUnit.Test_Suites;

package Surfaces_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Surfaces_Tests;
