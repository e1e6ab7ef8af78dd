--  SPDX-License-Identifier: Apache-2.0

--  SEM-1, SEM-2, MBX-3, KRN-2: two tasks under the real scheduler. One waits
--  for another of higher priority.

with AUnit.Test_Suites;

package Waiting_Tasks_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Waiting_Tasks_Tests;
