--  SPDX-License-Identifier: Apache-2.0

--  Every unit test, package by package.

with AUnit.Test_Suites;

package All_Tests is

   --  Briefly is for a build that executes contracts without optimisation. It
   --  omits tests with long flights or many starts, and those of a node on the
   --  machine's clock, whose work must fit in each tick.
   function Suite (Briefly : Boolean)
     return AUnit.Test_Suites.Access_Test_Suite;

end All_Tests;
