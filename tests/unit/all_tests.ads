--  SPDX-License-Identifier: Apache-2.0

--  Every unit test, package by package.

with AUnit.Test_Suites;

package All_Tests is

   --  Without those of a node on the machine's clock, where what is tested
   --  is too slow for that: such a node has each tick's work to do in a tick.
   function Suite (On_Clock : Boolean)
     return AUnit.Test_Suites.Access_Test_Suite;

end All_Tests;
