--  SPDX-License-Identifier: Apache-2.0

--  A row of the error log arrives on the ground exactly as it was sent (SAF-7,
--  D-15). Its 15 fragments in order make this row and no other, whatever
--  fragments came before. The theorem assumes that each fragment arrives
--  intact, as the checksum provides. A row with a missed fragment is not
--  written until it comes again.

with URVOS;           use URVOS;
with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Log_Pieces;  use URV.Log_Pieces;

package Theorems.Log_Pieces with Pure, SPARK_Mode, Ghost is

   procedure A_Row_Arrives
     (Item  : in out Receiver;
      Which : Log_Row_Number;
      Row   : Log_Row;
      Whole : out Boolean)
   with
     Global => null,
     Post   => Whole and then Item.Which = Which and then Item.Row = Row;

   --  A fragment above the flags of the error/status word is read back
   --  unchanged, and so are the flags.
   procedure A_Piece_Beside_The_Flags (Status : Word; Item : Piece)
   with
     Global => null,
     Pre    => Status < Piece_Unit,
     Post   =>
       Piece_Of (With_Piece (Status, Item)) = Item
       and then Without_Piece (With_Piece (Status, Item)) = Status;

end Theorems.Log_Pieces;
