--  The error log of a node between all who report to it, tasks, interrupt
--  handlers and kernel, and those who read it (EXT-1, SEM-2).
--
--  A report goes into the log at once, stamped with the tick the log was
--  last told: so none is lost when the processor restarts before the log
--  task runs, and there is nothing that could overflow between the two. The
--  log stays as it is until Clear, which belongs to a cold start alone.

with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;
with URV.Errors;   use URV.Errors;

generic
package URV.Shared_Errors
  with
    SPARK_Mode,
    Abstract_State =>
      (Shared_Log with Synchronous,
       External => (Async_Readers, Async_Writers)),
    Initializes    => Shared_Log
is

   --  The clock shows Now: the time of all reports until the next call.
   procedure Set_Time (Now : Clock_Tick)
   with
     Global  => (In_Out => Shared_Log),
     Depends => (Shared_Log => (Shared_Log, Now));

   --  An error has happened: see URV.Errors for the detail.
   procedure Report (Error : Error_Kind; Detail : Word)
   with
     Global  => (In_Out => Shared_Log),
     Depends => (Shared_Log => (Shared_Log, Error, Detail));

   --  Several errors of a kind have been counted by someone else.
   procedure Report_Several
     (Error     : Error_Kind;
      How_Often : Logs.Positive_Count;
      Detail    : Word)
   with
     Global  => (In_Out => Shared_Log),
     Depends => (Shared_Log => (Shared_Log, Error, How_Often, Detail));

   --  Nothing has happened yet.
   procedure Clear
   with
     Global  => (In_Out => Shared_Log),
     Depends => (Shared_Log => Shared_Log);

   --  The log as it stands, at one instant.
   procedure Inspect (Snapshot : out Error_Log)
   with
     Global  => (Input => Shared_Log),
     Depends => (Snapshot => Shared_Log);

end URV.Shared_Errors;
