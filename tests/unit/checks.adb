--  SPDX-License-Identifier: Apache-2.0

with AUnit;
with AUnit.Simple_Test_Cases;

package body Checks is

   type Check is new AUnit.Simple_Test_Cases.Test_Case with record
      Title : AUnit.Message_String;
      Run   : Test_Procedure;
   end record;

   type Check_Access is access Check;

   overriding function Name (Test : Check) return AUnit.Message_String is
     (Test.Title);

   overriding procedure Run_Test (Test : in out Check);

   overriding procedure Run_Test (Test : in out Check) is
   begin
      Test.Run.all;
   end Run_Test;

   procedure Add
     (Suite : not null AUnit.Test_Suites.Access_Test_Suite;
      Name  : String;
      Run   : not null Test_Procedure)
   is
      Test : constant Check_Access := new Check;
   begin
      Test.Title := AUnit.Format (Name);
      Test.Run   := Run;
      Suite.Add_Test (Test);
   end Add;

end Checks;
