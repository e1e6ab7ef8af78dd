--  SPDX-License-Identifier: Apache-2.0

--  LNK-4, LNK-7: the buffers that board and controller share.

with AUnit.Test_Suites;

package Board_Memory_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Board_Memory_Tests;
