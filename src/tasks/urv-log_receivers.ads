--  SPDX-License-Identifier: Apache-2.0

--  The aircraft's error log as it comes to the ground, a piece a downlink
--  (SAF-7). A row that is whole is written.

with Devices.Shared_CORE_Memory; use Devices.Shared_CORE_Memory;
with URVOS.Shared_Data;
with URV.Log_Pieces;             use URV.Log_Pieces;

generic
   CORE_Memory : in out Board;
package URV.Log_Receivers with SPARK_Mode is

   package Receivers is
     new URVOS.Shared_Data (Receiver, Initial => (others => <>));

   --  The row that is on its way.
   Incoming : Receivers.Store;

   procedure Take_Piece (Item : Piece)
   with Global => (In_Out => (Incoming, CORE_Memory));

end URV.Log_Receivers;
