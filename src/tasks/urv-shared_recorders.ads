--  SPDX-License-Identifier: Apache-2.0

--  The flight recorder's memory (FTI-9): the ring of rows, shared by the task
--  that records and the one that sends. Each row is written and read whole.
--  Only a cold start clears it.

with System;
with URV.Recorder_Rings; use URV.Recorder_Rings;
with URV.Recorder_Rows;  use URV.Recorder_Rows;
with URV.Recorder_Steps; use URV.Recorder_Steps;

package URV.Shared_Recorders with SPARK_Mode is

   type Row_Array is array (Row_Place) of Row;

   protected type Recorder with Priority => System.Priority'Last is

      --  Before the node is switched on. The ring is cleared.
      procedure Set_Length (Length : Ring_Length);

      procedure Clear;

      --  A frame is over: records its words unless the recorder has stopped.
      procedure Take (Words : Recorded_Words);

      --  Rows are fetched: the recorder stops until the aircraft flies.
      procedure Stop;

      function Contents return Ring;

      --  The row of that number, if it is held; else a row of zeros.
      function Row_At (Number : Row_Number) return Row;

   private
      Rows  : Row_Array;
      Kept  : Ring;
      Phase : Watch;
   end Recorder;

end URV.Shared_Recorders;
