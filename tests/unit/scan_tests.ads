--  Tests of the converter's scan: URV.AD_Scans.

with AUnit.Test_Suites;

package Scan_Tests is

   procedure Add_To (Suite : not null AUnit.Test_Suites.Access_Test_Suite);

end Scan_Tests;
