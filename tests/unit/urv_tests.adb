--  SPDX-License-Identifier: Apache-2.0

--  Runs the unit tests: one line for each test, then the totals. The exit
--  status is that of success only if every test passed.
--
--  urv_tests NUMBER SHARES [briefly]
--     every SHARES-th test: 1 2, 2 2; briefly: see All_Tests. Any other
--     arguments end it with an exception.

with Ada.Command_Line; use Ada.Command_Line;
with AUnit.Options;    use AUnit.Options;
with AUnit.Run;
with AUnit.Test_Suites;
with All_Tests;
with Live_Results;     use Live_Results;
with Test_Shares;      use Test_Shares;

procedure URV_Tests is
   type Choice is (Fully, Briefly);

   Chosen_So : constant Choice :=
     (if Argument_Count < 3 then Fully else Choice'Value (Argument (3)));

   function Suite return AUnit.Test_Suites.Access_Test_Suite is
     (All_Tests.Suite (Chosen_So = Briefly));

   procedure Run is new AUnit.Run.Test_Runner_With_Results (Suite);

   Chosen   : aliased Share;
   Options  : AUnit_Options := Default_Options;
   Reporter : Totals_Reporter;
   Results  : Live_Result;
begin
   if Argument_Count > 0 then
      Chosen.Number    := Positive'Value (Argument (1));
      Chosen.Of_Shares := Positive'Value (Argument (2));
      Options.Filter   := Chosen'Unchecked_Access;
   end if;
   Run (Reporter, Results, Options);
   Set_Exit_Status (if Results.Successful then Success else Failure);
end URV_Tests;
