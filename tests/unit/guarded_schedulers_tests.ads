--  Whose turn it is in real time, and when the node starts again.

with AUnit.Test_Suites;

package Guarded_Schedulers_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Guarded_Schedulers_Tests;
