--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's error log on its way to the ground (SAF-7): a piece a
--  frame, a row after the other, the rows of errors that have happened over
--  and over again. With an empty log there is no piece.
--  While the control laws are on, their row goes after each (EXT-3, EXT-5).

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS.Shared_Data;
with URV.Errors;          use URV.Errors;
with URV.Log_Pieces;      use URV.Log_Pieces;
with URV.Shared_Errors;   use URV.Shared_Errors;
with URV.Shared_Laws;
with URV.Shared_Surfaces;

generic
   Errors         : in out Shared_Log;
   Law_Settings   : in out URV.Shared_Laws.Settings.Store;
   Law_Memory     : in out URV.Shared_Laws.Memories.Store;
   Law_Configured : in out URV.Shared_Laws.Configured.Store;
   Surface_Memory : in out URV.Shared_Surfaces.Monitors.Store;
package URV.Log_Senders with SPARK_Mode is

   --  The row that is on its way, and how many of its pieces have gone.
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
       (Input  => (Errors, Law_Settings, Law_Memory, Law_Configured,
                   Surface_Memory),
        In_Out => Progress);

end URV.Log_Senders;
