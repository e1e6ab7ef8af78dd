--  SPDX-License-Identifier: Apache-2.0

--  An error log that tasks, interrupt handlers and the kernel write, and that
--  monitors read (EXT-1, SEM-2).
--
--  A report goes into the log at once, stamped with the tick the log was
--  last told: so none is lost when the processor restarts before anybody
--  reads it, and there is nothing that could overflow between the two. The
--  log stays as it is until a cold start.

with URVOS.Error_Logs;
with URVOS.Frames; use URVOS.Frames;
with URVOS.Starts; use URVOS.Starts;

generic
   with package Logs is new URVOS.Error_Logs (<>);
package URVOS.Shared_Error_Logs with SPARK_Mode is

   protected type Shared_Log is

      --  The clock shows Tick_Now: the time of all reports until the next
      --  call.
      procedure Set_Time (Tick_Now : Clock_Tick);

      --  An error has happened.
      procedure Report (Error : Logs.Error_Kind; Detail : Word);

      --  Several errors of a kind, which the caller has counted.
      procedure Report_Several
        (Error     : Logs.Error_Kind;
         How_Often : Logs.Positive_Count;
         Detail    : Word);

      --  The node starts: Logs.After_Start.
      procedure Start (Condition : Start_Condition; Passed : Boolean);

      --  Nothing has happened yet.
      procedure Clear;

      --  The whole log, read at one instant.
      function Contents return Logs.Error_Log;

      --  Parts of it, each read at one instant. The whole log is a large copy.

      function Summary return Logs.Summary;

      function History_Of (Kind : Logs.Error_Kind) return Logs.History;

      --  See Logs.Next_Occurred. An empty log is not searched.
      function Next_Occurred (Kind : Logs.Error_Kind) return Logs.Error_Kind;

      --  The tick of the last Set_Time.
      function Time return Clock_Tick;

   private
      Present : Logs.Error_Log := Logs.Empty_Log;
      Now     : Clock_Tick     := 0;
   end Shared_Log;

end URVOS.Shared_Error_Logs;
