--  SPDX-License-Identifier: Apache-2.0

--  The start of a node (report, sections 2.3 and 3.1; INI-1 to INI-8, SAF-4,
--  SAF-6, TST-4). The telemetry board starts by itself.
--
--  A cold start, at power up, clears CORE and the error log, and empties all
--  variables. A warm start, at the reset switch or an unexpected exception,
--  keeps CORE, the error log and the last messages. It resets all flags and
--  counts (D-41). No start acts on blocks that the telemetry board received
--  earlier.

with Devices.Processor_Memories;
with Telemetry.Shared_Boards;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Starts;      use URVOS.Starts;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Seals;

generic
   with package Memories is new Devices.Processor_Memories (<>);
   CORE_Memory     : in out URV.Shared_CORE_Memory.Board;
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   Sealing         : in out URV.Shared_Seals.Shared_Seal;
   Errors          : in out Shared_Log;

   --  The node's own part: a cold start puts its variables in their first
   --  state, and a warm start restarts them. Both initialise its A/D board
   --  and clear its status. In the aircraft the servos are included.
   with procedure Reset_Variables;
   with procedure Restart_Variables;

   --  Called after a failed self-test. The node then stays silent except for
   --  this report.
   with procedure Report_Refused_Start;
package URV.Start_Routines with SPARK_Mode is

   --  Phases 1 and 2: the self-test, and the controller's routine for the
   --  start condition. If Passed is False, no tasks are loaded.
   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

end URV.Start_Routines;
