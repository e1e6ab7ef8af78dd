--  SPDX-License-Identifier: Apache-2.0

--  Unit tests of both nodes.

with AUnit.Test_Suites;

package Node_Suite is

   --  INI-1, KRN-6, FRM-4: starts that are wished for while tasks run.
   package Shared_Nodes_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Shared_Nodes_Tests;

   --  KRN-1 to KRN-6, EXT-4: a node of Ada tasks, on the machine's clock.
   package Real_Time_Nodes_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Real_Time_Nodes_Tests;

   --  KRN-6: what a partition makes of an exception in a task's step.
   package Guarded_Step_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Guarded_Step_Tests;

   --  INI-1 to INI-8, TST-4, KRN-5, KRN-6, EXT-4: how a node starts, and what
   --  each kind of start clears and keeps.
   package Starts_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end Starts_Tests;

   --  Tests of what the nodes find out about themselves in flight: the check
   --  of the program memory, tasks that come late.
   package In_Flight_Tests is

      procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

   end In_Flight_Tests;

   --  TST-1 to TST-4: what the self-test finds, and that it finds nothing
   --  where nothing is wrong.
   package Self_Test_Tests is

      --  Briefly: without the thousand starts.
      procedure Add_To
        (Suite : AUnit.Test_Suites.Access_Test_Suite; Briefly : Boolean);

   end Self_Test_Tests;

end Node_Suite;
