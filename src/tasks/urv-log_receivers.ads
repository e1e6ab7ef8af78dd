--  SPDX-License-Identifier: Apache-2.0

--  Receives the aircraft's error log on the ground, a fragment a downlink
--  (SAF-7). A complete row is written.

with URVOS.Shared_Data;
with URV.Log_Pieces;         use URV.Log_Pieces;
with URV.Shared_CORE_Memory; use URV.Shared_CORE_Memory;

generic
   CORE_Memory : in out Board;
package URV.Log_Receivers with SPARK_Mode is

   package Receivers is
     new URVOS.Shared_Data (Receiver, Initial => (others => <>));

   --  The row under reception.
   Incoming : Receivers.Store;

   procedure Take_Piece (Item : Piece)
   with Global => (In_Out => (Incoming, CORE_Memory));

   --  A frame without a fragment.
   procedure Miss_Piece
   with Global => (In_Out => Incoming);

   --  Ends the row under reception: during a start fragments are missed.
   procedure Restart
   with Global => (In_Out => Incoming);

end URV.Log_Receivers;
