--  SPDX-License-Identifier: Apache-2.0

--  MBX-1 to MBX-5 and INI-8: the mailbox, alone and between two tasks.

with AUnit.Test_Suites;

package Mailboxes_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Mailboxes_Tests;
