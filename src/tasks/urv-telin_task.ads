--  SPDX-License-Identifier: Apache-2.0

--  TELIN task: takes what the telemetry board received (report, 4.4, table 4;
--  TIN-1, D-14). Released at minor frame 0.
--
--  Consumes the board's receive buffers, produces TELIN_variable. A frame
--  with nothing new passes on the message before, marked as old (SAF-5).
--  Nothing is sent until the board has received its first message, nor
--  after a restart until a message has come: the one before the restart is
--  lost, and what stands for it would reach the servos.
--
--  A block that the seal does not open is none (SEC-1).

with Telemetry;         use Telemetry;
with Telemetry.Shared_Boards;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Shared_Data;
with URVOS.Shared_Mailboxes;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Seals;

generic
   with package Messages is new URVOS.Shared_Mailboxes (<>);
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   TELIN_Variable  : in out Messages.Variable;
   Sealing         : in out URV.Shared_Seals.Shared_Seal;
   Errors          : in out Shared_Log;
   with function As_Old
     (Source : Messages.Message) return Messages.Message;
   with function Decode (Data : Block_Data) return Messages.Message;
package URV.TELIN_Task with SPARK_Mode is

   type Kept_Message is record
      Buffer      : Messages.Message := Messages.Neutral;
      Has_Message : Boolean          := False;
   end record;

   package Stores is new URVOS.Shared_Data (Kept_Message, (others => <>));

   Previous : Stores.Store;

   procedure Initialise
   with Global => (In_Out => Previous);

   procedure Run_Transaction (Now : Clock_Tick)
   with
     Global =>
       (In_Out =>
          (Previous, Telemetry_Board, TELIN_Variable, Sealing, Errors));

end URV.TELIN_Task;
