--  SPDX-License-Identifier: Apache-2.0

--  A test is a name and a procedure. The name gives the requirement and the
--  behaviour; the procedure fails through Expectations.

with AUnit.Test_Suites;

package Checks is

   type Test_Procedure is access procedure;

   procedure Add
     (Suite : not null AUnit.Test_Suites.Access_Test_Suite;
      Name  : String;
      Run   : not null Test_Procedure);

end Checks;
