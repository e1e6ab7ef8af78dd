--  SPDX-License-Identifier: Apache-2.0

--  A row of the error log arrives on the ground exactly as it was sent (SAF-7,
--  D-15). Its 15 fragments in order make this row and no other, whatever
--  fragments came before. The theorem assumes that each fragment arrives
--  intact, as the checksum provides. A row with a missed fragment is not
--  written until it comes again: in a gap of up to 14 fragments the sender
--  reaches another place, and a longer gap is a silence that ends the row.

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

   --  A fragment that comes after others of up to a row were missed is not
   --  taken for the next one of the row under reception.
   procedure A_Gap_Leaves_Another_Place
     (Item : Receiver; Missed : Place; Next : Piece)
   with
     Global => null,
     Pre    =>
       Item.Got > 0
       and then Missed < Place'Last
       and then Next / 256 = Word ((Item.Got + Missed) mod Place'Last) + 1,
     Post   => not Is_Next (Item, Next);

   --  No row is under reception any more after Most_Silent + 1 frames without
   --  a fragment, half of a row.
   procedure Silence_Ends_A_Row (Item : in out Receiver)
   with
     Global => null,
     Post   => Item.Got = 0;

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
