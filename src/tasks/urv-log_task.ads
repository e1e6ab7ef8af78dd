--  SPDX-License-Identifier: Apache-2.0

--  LOG task: keeps the error log complete and its sums in CORE memory (EXT-1;
--  the report names the task in 4.3.3 and leaves it for later). Released at
--  minor frame 5, after all tasks that report.
--
--  All other units report to the log directly. The telemetry board cannot:
--  this task reads its statistics and logs any increase in the same frame. It
--  produces the log's words of CORE's status, and one row a frame of the log
--  in CORE, all rows in turn (SAF-7).

with Devices.Shared_CORE_Memory;
with Telemetry.Boards;    use Telemetry.Boards;
with Telemetry.Shared_Boards;
with URVOS.Shared_Data;
with URV.Errors;          use URV.Errors;
with URV.Shared_Errors;   use URV.Shared_Errors;

generic
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   CORE_Memory     : in out Devices.Shared_CORE_Memory.Board;
   Errors          : in out Shared_Log;
package URV.LOG_Task with SPARK_Mode is

   type Progress is record
      Seen_Tally   : Statistics := (others => 0);

      --  The kind whose row is written next.
      Kind_In_Turn : Error_Kind := Error_Kind'First;
   end record;

   package Stores is new URVOS.Shared_Data (Progress, (others => <>));

   Seen : Stores.Store;

   --  After a cold start, which leaves no restart in the log, the board's
   --  counts up to now are not new errors. Any other start keeps the counts
   --  seen before.
   procedure Initialise
   with
     Global => (Input => (Telemetry_Board, Errors), In_Out => Seen);

   procedure Run_Transaction
   with
     Global =>
       (Input => Telemetry_Board, In_Out => (Seen, CORE_Memory, Errors));

end URV.LOG_Task;
