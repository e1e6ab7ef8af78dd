--  SPDX-License-Identifier: Apache-2.0

--  GDCIN task: gives the aircraft's messages to CORE (report, 5.5, table 9;
--  GDI-1, D-11, D-14). Released at minor frame 1 of the report's schedule.
--
--  Consumes TELIN_variable, produces downlink_variable, with the frame that
--  the message's spare bits carry (FTI-12). The fragment of the
--  aircraft's error log goes to the log's receiver (SAF-7). A frame without a
--  new message passes on the last one, marked as old.
--
--  A block of the aircraft's flight recorder goes to the station (FTI-10). A
--  block of any other kind is reported and discarded (EXT-2). In both cases
--  CORE gets the last message, marked as old.

with URVOS.Shared_Data;
with URV.Buffers;       use URV.Buffers;
with URV.Log_Pieces;    use URV.Log_Pieces;
with URV.Mailboxes;     use URV.Mailboxes;
with URV.Shared_Errors; use URV.Shared_Errors;

generic
   TELIN_Variable    : in out For_Downlink.Variable;
   Downlink_Variable : in out For_Framed_Downlink.Variable;
   Recorder_Blocks   : in out For_Downlink.Variable;
   Errors            : in out Shared_Log;
   with procedure Take_Piece (Item : Piece);
   with procedure Miss_Piece;
package URV.GDCIN_Task with SPARK_Mode is

   package Stores is
     new URVOS.Shared_Data (Downlink_Buffer, Neutral_Downlink);

   --  The last message for CORE. It survives a warm start and is neutral after
   --  a cold start.
   Previous : Stores.Store;

   procedure Reset
   with Global => (In_Out => Previous);

   procedure Run_Transaction;

end URV.GDCIN_Task;
