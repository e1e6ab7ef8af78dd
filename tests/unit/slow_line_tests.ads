--  SPDX-License-Identifier: Apache-2.0

--  Boards on a line slower than a wire (LNK-11).

with AUnit.Test_Suites;

package Slow_Line_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Slow_Line_Tests;
