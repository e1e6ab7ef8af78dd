--  SPDX-License-Identifier: Apache-2.0

--  How a node starts (report, sections 2.3 and 3.1; INI-1 to INI-8, SAF-4,
--  SAF-6, TST-4). The telemetry board starts by itself.
--
--  Power up clears CORE and the error log, and nothing has been sent or
--  received. After the reset switch or an unexpected exception CORE, the
--  error log and the last messages stay, all flags and counts start anew
--  (D-41).
--  What the telemetry board received before a start is not acted on.

with Devices.Processor_Memories;
with Devices.Shared_AD_Board;
with Devices.Shared_CORE_Memory;
with Telemetry.Shared_Boards;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Starts;       use URVOS.Starts;
with URV.Shared_Errors;  use URV.Shared_Errors;
with URV.Shared_Seals;
with URV.Shared_Status;  use URV.Shared_Status;

generic
   with package Memories is new Devices.Processor_Memories (<>);
   AD_Board        : in out Devices.Shared_AD_Board.Board;
   CORE_Memory     : in out Devices.Shared_CORE_Memory.Board;
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   Sealing         : in out URV.Shared_Seals.Shared_Seal;
   Errors          : in out Shared_Log;
   Node_Status     : in out Status;

   --  What else a cold start puts in its first state, and what begins anew
   --  at a warm one: the variables, and in the aircraft the servos.
   with procedure Reset_Variables;
   with procedure Restart_Variables;

   --  A failed self-test: the node stays silent, but for what it says here.
   with procedure Say_Refused;
package URV.Start_Routines with SPARK_Mode is

   --  Phases 1 and 2: self-test and the controller's routine of the start
   --  condition. Passed tells whether there are tasks to be loaded.
   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

end URV.Start_Routines;
