--  SPDX-License-Identifier: Apache-2.0

--  Runs the unit tests: one line a test, then the totals. The exit status
--  is that of success only if every test passed.

with Ada.Command_Line; use Ada.Command_Line;
with AUnit.Run;
with All_Tests;
with Live_Results;     use Live_Results;

procedure URV_Tests is
   procedure Run is
     new AUnit.Run.Test_Runner_With_Results (All_Tests.Suite);

   Reporter : Totals_Reporter;
   Results  : Live_Result;
begin
   Run (Reporter, Results);
   Set_Exit_Status (if Results.Successful then Success else Failure);
end URV_Tests;
