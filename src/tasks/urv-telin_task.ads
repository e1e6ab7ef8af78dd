--  SPDX-License-Identifier: Apache-2.0

--  TELIN task: takes blocks from the telemetry board (report, 4.4, table 4;
--  TIN-1, D-14). Released at minor frame 0 of the report's schedule.
--
--  Consumes the board's receive buffers, produces TELIN_variable. A frame
--  without a new message passes on the last one, marked as old (SAF-5). After
--  any start it sends nothing until a message has come. A restart loses the
--  last message, and its substitute must not reach the servos.
--
--  A block that the seal does not open is ignored (SEC-1).

with Telemetry.Shared_Boards;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Shared_Data;
with URVOS.Shared_Mailboxes;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Seals;
with URV.TELIN_Steps;

generic
   with package Steps is new URV.TELIN_Steps (<>);
   with package Messages is
     new URVOS.Shared_Mailboxes (Message => Steps.Message, others => <>);
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   TELIN_Variable  : in out Messages.Variable;
   Sealing         : in out URV.Shared_Seals.Shared_Seal;
   Errors          : in out Shared_Log;
package URV.TELIN_Task with SPARK_Mode is

   package Stores is
     new URVOS.Shared_Data (Steps.Kept_Message, (others => <>));

   Previous : Stores.Store;

   procedure Initialise
   with Global => (In_Out => Previous);

   --  Is_New: a message came in this frame and is not marked as old.
   procedure Run_Transaction (Now : Clock_Tick; Is_New : out Boolean)
   with
     Global =>
       (In_Out =>
          (Previous, Telemetry_Board, TELIN_Variable, Sealing, Errors));

end URV.TELIN_Task;
