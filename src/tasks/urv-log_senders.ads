--  The aircraft's error log on its way to the ground (SAF-7): a piece a
--  frame, a row after the other, the rows of errors that have happened over
--  and over again. With an empty log there is no piece.

with URV.Errors;     use URV.Errors;
with URV.Log_Pieces; use URV.Log_Pieces;

generic
   with procedure Inspect_Log (Snapshot : out Error_Log);
package URV.Log_Senders
  with
    SPARK_Mode,
    Abstract_State => Progress,
    Initializes    => Progress
is

   procedure Next (Item : out Piece);

end URV.Log_Senders;
