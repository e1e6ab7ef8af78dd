--  SPDX-License-Identifier: Apache-2.0

--  PWM-2, D-2, D-8, D-10, D-11: from commands to servos.

with AUnit.Test_Suites;

package PWM_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end PWM_Tests;
