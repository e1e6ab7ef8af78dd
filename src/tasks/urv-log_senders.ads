--  SPDX-License-Identifier: Apache-2.0

--  Sends the aircraft's error log to the ground (SAF-7): a fragment a frame,
--  row after row, repeatedly, the rows of all errors that have occurred. An
--  empty log has no fragment. While the control laws are on, their row follows
--  each row (EXT-3, EXT-5).

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS.Shared_Data;
with URV.Errors;          use URV.Errors;
with URV.Log_Pieces;      use URV.Log_Pieces;
with URV.Shared_Errors;   use URV.Shared_Errors;
with URV.Shared_Laws;

generic
   Errors         : in out Shared_Log;
   Law_Settings   : in out URV.Shared_Laws.Settings.Store;
   Law_Memory     : in out URV.Shared_Laws.Memories.Store;
package URV.Log_Senders with SPARK_Mode is

   --  The row being sent, and the number of its fragments already sent.
   type Outgoing is record
      Kind    : Error_Kind  := Error_Kind'Last;
      Is_Laws : Boolean     := False;
      Row     : Log_Row     := No_Errors;
      Sent    : Place_Count := Place'Last;
   end record;

   package Senders is
     new URVOS.Shared_Data (Outgoing, Initial => (others => <>));

   Progress : Senders.Store;

   procedure Next (Item : out Piece)
   with
     Global =>
       (Input => (Errors, Law_Settings, Law_Memory), In_Out => Progress);

end URV.Log_Senders;
