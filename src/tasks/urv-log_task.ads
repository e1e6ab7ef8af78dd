--  LOG task: keeps the error log complete and its sums in CORE memory
--  (EXT-1; the report names the task in 4.3.3 and leaves it for later).
--  Released at minor frame 5, after all tasks that report.
--
--  Everyone else reports to the log as it happens. The telemetry board can
--  not: this task reads its statistics and logs what is new in them, in the
--  frame in which it finds it. Produces the log's words of CORE's status, and
--  a row a frame of the log in CORE, all rows in turn (SAF-7).

with Devices.CORE_Memory; use Devices.CORE_Memory;
with Telemetry.Boards;    use Telemetry.Boards;
with URVOS;               use URVOS;
with URV.Errors;          use URV.Errors;

generic
   with procedure Inspect_Link (Tally : out Statistics);
   with procedure Report_Several
     (Error     : Error_Kind;
      How_Often : Logs.Positive_Count;
      Detail    : Word);
   with procedure Inspect_Log (Snapshot : out Error_Log);
   with procedure Write_Status (Words : Status_Array);
   with procedure Write_Log (Which : Log_Row_Number; Row : Log_Row);
package URV.LOG_Task
  with
    SPARK_Mode,
    Abstract_State => Seen,
    Initializes    => Seen
is

   --  After a cold start, which leaves no restart in the log, and after no
   --  other: what the board has counted up to now is nothing new.
   procedure Initialise;

   procedure Run_Transaction;

end URV.LOG_Task;
