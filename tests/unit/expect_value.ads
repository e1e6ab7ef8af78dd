--  SPDX-License-Identifier: Apache-2.0

--  Expects a number or a name. A failure reports its subject, both values and
--  the test's line; it ends the test.

with GNAT.Source_Info;

generic
   type Value is (<>);
procedure Expect_Value
  (What             : String;
   Actual, Expected : Value;
   Source           : String   := GNAT.Source_Info.File;
   Line             : Positive := GNAT.Source_Info.Line);
