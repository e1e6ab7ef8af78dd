--  SPDX-License-Identifier: Apache-2.0

--  Sends the aircraft's error log to the ground (SAF-7): a fragment a frame,
--  row after row, repeatedly, the rows of all errors that have occurred. An
--  empty log has no fragment. While the control laws are on, their row follows
--  each row (EXT-3, EXT-5). With test cards their row takes turns with it
--  (FTI-2).

with URVOS.Shared_Data;
with URV.Log_Pieces;    use URV.Log_Pieces;
with URV.LOG_Steps;     use URV.LOG_Steps;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Laws;

generic
   Errors       : in out Shared_Log;
   Law_Settings : in out URV.Shared_Laws.Settings.Store;
   Law_Memory   : in out URV.Shared_Laws.Memory_Store;
package URV.Log_Senders with SPARK_Mode is

   package Senders is
     new URVOS.Shared_Data (Outgoing, Initial => (others => <>));

   Progress : Senders.Store;

   procedure Next (Item : out Piece)
   with
     Global =>
       (Input => (Errors, Law_Settings, Law_Memory), In_Out => Progress);

   --  Ends the row that is being sent: after a cold start it is of another
   --  flight.
   procedure Restart
   with Global => (In_Out => Progress);

end URV.Log_Senders;
