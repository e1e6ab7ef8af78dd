--  SPDX-License-Identifier: Apache-2.0

--  Records a major frame of the aircraft (FTI-9). The LOG task's step calls it
--  as its last act, when all words of the frame are in CORE and at the servos.
--  It reads and copies only: nothing else depends on it.

with URV.PWM_Boards;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Laws;
with URV.Shared_Recorders;

generic
   CORE_Memory : in out URV.Shared_CORE_Memory.Board;
   PWM_Board   : in out PWM_Boards.Board;
   Law_Record  : in out URV.Shared_Laws.Records.Store;
   Errors      : in out Shared_Log;
   Recorder    : in out URV.Shared_Recorders.Recorder;
package URV.Flight_Recorder with SPARK_Mode is

   procedure Record_Frame
   with
     Global =>
       (Input  => (CORE_Memory, PWM_Board, Law_Record, Errors),
        In_Out => Recorder);

end URV.Flight_Recorder;
