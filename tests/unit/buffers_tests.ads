--  SPDX-License-Identifier: Apache-2.0

--  BUF-1 to BUF-3 and INI-8: the layout of the buffers, against the lists
--  of the requirements.

with AUnit.Test_Suites;

package Buffers_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Buffers_Tests;
