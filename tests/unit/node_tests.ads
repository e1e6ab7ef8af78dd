--  Tests of the tasks where they work: in the two nodes as they are wired.

with AUnit.Test_Suites;

package Node_Tests is

   procedure Add_To (Suite : not null AUnit.Test_Suites.Access_Test_Suite);

end Node_Tests;
