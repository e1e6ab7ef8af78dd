--  SPDX-License-Identifier: Apache-2.0

--  The LAW task's reports of a frame (EXT-2, EXT-3, EXT-5, EXT-6, FTI-2):
--  missing inputs, a refused configuration or card, the end of a card, changes
--  of the link's state, and new failures of sensors, surfaces and the engine.

with URV.Buffers;       use URV.Buffers;
with URV.LAW_Steps;     use URV.LAW_Steps;
with URV.Laws;          use URV.Laws;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Surfaces;      use URV.Surfaces;
with URV.Test_Runs;

generic
   Errors : in out Shared_Log;
package URV.LAW_Reports with SPARK_Mode is

   --  The parts of LAW's memory whose changes are reported.
   type Sensor_Flags is array (Sensor_Item) of Boolean
   with Alignment => 2;

   type State is record
      Link          : Link_State;
      Is_Valid      : Sensor_Flags;
      Failed        : Surface_Flags;
      Engine_Failed : Boolean;
   end record;

   function State_Of (Memory : Kept) return State is
     ((Link          => Memory.Flown.Link.State,
       Is_Valid      =>
         (for Sensor in Sensor_Item => Memory.Flown.Checks (Sensor).Is_Valid),
       Failed        => Memory.Watched.Failed,
       Engine_Failed => Memory.Watched.Engine.Failed))
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
