--  SPDX-License-Identifier: Apache-2.0

--  Every unit test, package by package.

with AUnit.Test_Suites;

package All_Tests is

   --  Briefly: for a build that executes contracts without optimisation.
   --  Without those that fly for long or start often, and without those of a
   --  node on the machine's clock: it would have each tick's work to do in a
   --  tick.
   function Suite (Briefly : Boolean)
     return AUnit.Test_Suites.Access_Test_Suite;

end All_Tests;
