--  SPDX-License-Identifier: Apache-2.0

--  EXT-6: a surface that fails is named, and the others make up for it.

with AUnit.Test_Suites;

package Surfaces_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Surfaces_Tests;
