--  SPDX-License-Identifier: Apache-2.0

--  BUF-1 to BUF-3, D-1, D-3: names, words, wire bytes, and the path from a
--  converter image to a buffer.

with AUnit.Test_Suites;

package Codecs_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Codecs_Tests;
