--  SPDX-License-Identifier: Apache-2.0

--  TELOUT task: gives the telemetry board a block to transmit (report, 4.5,
--  table 5; TOU-1). Released at minor frame 2 of the report's schedule.
--
--  Consumes TELOUT_variable, produces the board's transmit buffers. If no
--  buffer is free, the newest data overwrites older data. Without a new
--  message it writes nothing. The block is sealed first (SEC-1).

with Telemetry.Shared_Boards;
with URVOS.Shared_Mailboxes;
with URV.Plain_Blocks;  use URV.Plain_Blocks;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Seals;

generic
   with package Messages is new URVOS.Shared_Mailboxes (<>);
   TELOUT_Variable : in out Messages.Variable;
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   Sealing         : in out URV.Shared_Seals.Shared_Seal;
   Errors          : in out Shared_Log;
   with function Words_Of (Item : Messages.Message) return Block_Words;
package URV.TELOUT_Task with SPARK_Mode is

   procedure Run_Transaction
   with
     Global =>
       (In_Out => (TELOUT_Variable, Telemetry_Board, Sealing, Errors));

end URV.TELOUT_Task;
