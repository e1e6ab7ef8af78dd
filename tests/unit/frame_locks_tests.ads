--  SPDX-License-Identifier: Apache-2.0

--  FRM-6: frames of 9 to 11 ticks, and the lock that keeps them in step.

with AUnit.Test_Suites;

package Frame_Locks_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Frame_Locks_Tests;
