--  SPDX-License-Identifier: Apache-2.0

--  The LAW task's reports of a frame (EXT-2, EXT-3, EXT-5, EXT-6, FTI-2):
--  missing inputs, a refused configuration or card, the end of a card, changes
--  of the link's state, and new failures of sensors, surfaces and the engine.

with URVOS;             use URVOS;
with URV.LAW_Steps;     use URV.LAW_Steps;
with URV.Laws;          use URV.Laws;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.Recorder_Rows; use URV.Recorder_Rows;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Test_Runs;

generic
   Errors : in out Shared_Log;
package URV.LAW_Reports with SPARK_Mode is

   --  The parts of LAW's memory whose changes are reported. The words are
   --  those of URV.Law_Status, a bit for each sensor and each surface.
   type State is record
      Link                               : Link_State;
      Invalid_Low, Invalid_High, Failed : Word;
   end record;

   --  Words are those that the flight recorder has of the memory.
   function State_Of (Link : Link_State; Words : Law_Words) return State is
     ((Link         => Link,
       Invalid_Low  => Words (2),
       Invalid_High => Words (3),
       Failed       => Words (5)))
   with Global => null;

   --  Cards: the state of the test cards after the frame.
   procedure Report
     (Before : State;
      After  : State;
      Usual  : Settings;
      Got    : Inputs;
      Result : Decision;
      Cards  : Test_Runs.Run)
   with Global => (In_Out => Errors);

end URV.LAW_Reports;
