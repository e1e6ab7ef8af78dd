--  SPDX-License-Identifier: Apache-2.0

--  LOG task: keeps the error log complete and its sums in CORE memory (EXT-1;
--  the report names the task in 4.3.3 and leaves it for later). Released at
--  minor frame 5 of the report's schedule, after all tasks that report.
--
--  All other units report to the log directly. The telemetry board cannot:
--  this task reads its statistics and logs any increase in the same frame. It
--  produces the log's words of CORE's status, and one row a frame of the log
--  in CORE, all rows in turn (SAF-7).

with Telemetry.Shared_Boards;
with URVOS.Shared_Data;
with URV.LOG_Steps;     use URV.LOG_Steps;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors; use URV.Shared_Errors;

generic
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   CORE_Memory     : in out URV.Shared_CORE_Memory.Board;
   Errors          : in out Shared_Log;
package URV.LOG_Task with SPARK_Mode is

   package Stores is new URVOS.Shared_Data (Progress, (others => <>));

   Seen : Stores.Store;

   procedure Initialise
   with
     Global => (Input => (Telemetry_Board, Errors), In_Out => Seen);

   procedure Run_Transaction
   with
     Global =>
       (Input => Telemetry_Board, In_Out => (Seen, CORE_Memory, Errors));

end URV.LOG_Task;
