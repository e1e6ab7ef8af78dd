--  SPDX-License-Identifier: Apache-2.0

--  SEM-1, SEM-2: the owner of a semaphore, and the wait of a P.

with AUnit.Test_Suites;

package Semaphores_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Semaphores_Tests;
