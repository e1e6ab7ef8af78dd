--  SPDX-License-Identifier: Apache-2.0

--  The boards of a node in its partition, and the node's stores that the
--  partition reads (RTP-1).

with Devices.Memory_Bus;
with Telemetry.Shared_Boards;
with URV.AD_Boards;
with URV.Shared_Errors;
with URV.Shared_Schedules;
with URV.Shared_Seals;

--  A signature: who instantiates with it references its formals.
pragma Warnings (Off, "*is not referenced");

generic
   AD_Board        : in out URV.AD_Boards.Board;
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   Errors          : in out URV.Shared_Errors.Shared_Log;
   Sealing         : in out URV.Shared_Seals.Shared_Seal;
   Schedule        : in out URV.Shared_Schedules.Store;
   Processor_Board : Devices.Memory_Bus.Board_Number;
   with procedure Handle_AD_Interrupt;
package Partitions.Boards is

end Partitions.Boards;
