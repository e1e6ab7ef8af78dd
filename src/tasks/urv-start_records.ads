--  SPDX-License-Identifier: Apache-2.0

--  Records each start for later analysis (report, 2.3.4; INI-6, TST-4). CORE's
--  status has the number of starts of each kind, and the last self-test's
--  result. The error log has the warm starts and the failures.

with URVOS.Self_Tests;       use URVOS.Self_Tests;
with URVOS.Starts;           use URVOS.Starts;
with URV.Shared_CORE_Memory; use URV.Shared_CORE_Memory;
with URV.Shared_Errors;      use URV.Shared_Errors;

generic
   CORE_Memory : in out Board;
   Errors      : in out Shared_Log;
package URV.Start_Records with SPARK_Mode is

   procedure Record_Start
     (Condition : Start_Condition;
      Result    : Test_Result)
   with Global => (In_Out => (CORE_Memory, Errors));

end URV.Start_Records;
