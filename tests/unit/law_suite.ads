--  SPDX-License-Identifier: Apache-2.0

--  Unit tests of the control laws and the servos.

with AUnit.Test_Suites;

package Law_Suite is

   --  EXT-3, EXT-5: the control laws, the loss of the link, the sensors'
   --  checks.
   package Laws_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Laws_Tests;

   --  SAF-10: what the ground's converter gives for a silent console.
   package Console_Watch_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Console_Watch_Tests;

   --  EXT-3, MBX-2: what the LAW task reports, and when.
   package LAW_Task_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end LAW_Task_Tests;

   --  PWM-2, D-2, D-8, D-10, D-11: from commands to servos.
   package PWM_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end PWM_Tests;

   --  EXT-6: a surface that fails is named, and the others make up for it.
   package Surfaces_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Surfaces_Tests;

   --  FTI-1 to FTI-6: test cards and their inputs.
   package Test_Cards_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Test_Cards_Tests;

end Law_Suite;
