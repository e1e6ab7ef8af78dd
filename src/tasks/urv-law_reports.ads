--  SPDX-License-Identifier: Apache-2.0

--  The LAW task's reports of a frame (EXT-2, EXT-3, EXT-5, EXT-6, FTI-2):
--  missing inputs, a refused configuration or card, the end of a card, changes
--  of the link's state, and new failures of sensors, surfaces and the engine.

with URV.LAW_Steps;     use URV.LAW_Steps;
with URV.Laws;          use URV.Laws;
with URV.Shared_Errors; use URV.Shared_Errors;

generic
   Errors : in out Shared_Log;
package URV.LAW_Reports with SPARK_Mode is

   procedure Report
     (Before : Kept; Usual : Settings; Got : Inputs; Result : Decision)
   with Global => (In_Out => Errors);

end URV.LAW_Reports;
