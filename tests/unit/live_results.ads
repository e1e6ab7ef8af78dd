--  SPDX-License-Identifier: Apache-2.0

--  Tells the result of each test in one line, as soon as it is known, so
--  that a program that dies shows how far it came. The last line is the
--  totals.

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

   --  An exception that the test did not expect.
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
