--  SPDX-License-Identifier: Apache-2.0

--  Writes the result of each test in one line at once, so the output of a
--  program that dies shows its last test. The last line has the totals.

with AUnit;              use AUnit;
with AUnit.Options;
with AUnit.Reporter;
with AUnit.Test_Results; use AUnit.Test_Results;
with AUnit.Time_Measure; use AUnit.Time_Measure;

package Live_Results is

   type Live_Result is new Result with null record;

   overriding procedure Add_Success
     (R            : in out Live_Result;
      Test_Name    : Message_String;
      Routine_Name : Message_String;
      Elapsed      : Time);

   overriding procedure Add_Failure
     (R            : in out Live_Result;
      Test_Name    : Message_String;
      Routine_Name : Message_String;
      Failure      : Test_Failure;
      Elapsed      : Time);

   --  An unexpected exception in the test.
   overriding procedure Add_Error
     (R            : in out Live_Result;
      Test_Name    : Message_String;
      Routine_Name : Message_String;
      Error        : Test_Error;
      Elapsed      : Time);

   type Totals_Reporter is new AUnit.Reporter.Reporter with null record;

   overriding procedure Report
     (Engine  : Totals_Reporter;
      R       : in out Result'Class;
      Options : AUnit.Options.AUnit_Options := AUnit.Options.Default_Options);

end Live_Results;
