--  The aircraft's error log as it comes to the ground, a piece a downlink
--  (SAF-7). A row that is whole is written.

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URV.Log_Pieces;      use URV.Log_Pieces;

generic
   with procedure Write_Row (Which : Log_Row_Number; Row : Log_Row);
package URV.Log_Receivers
  with
    SPARK_Mode,
    Abstract_State => Incoming,
    Initializes    => Incoming
is

   procedure Take_Piece (Item : Piece);

end URV.Log_Receivers;
