--  SPDX-License-Identifier: Apache-2.0

--  A row of the error log comes down as it is (SAF-7, D-15): of all that may
--  have come before, its 15 pieces make it, and no other row.

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS;               use URVOS;
with URV.Log_Pieces;      use URV.Log_Pieces;

package Theorems.Log_Pieces with Pure, SPARK_Mode, Ghost is

   procedure A_Row_Arrives
     (Item  : in out Receiver;
      Which : Log_Row_Number;
      Row   : Log_Row;
      Whole : out Boolean)
   with
     Global => null,
     Post   => Whole and then Item.Which = Which and then Item.Row = Row;

   --  A piece beside the flags of the error/status word comes out again, and
   --  the flags are as they were.
   procedure A_Piece_Beside_The_Flags (Status : Word; Item : Piece)
   with
     Global => null,
     Pre    => Status < Piece_Unit,
     Post   =>
       Piece_Of (With_Piece (Status, Item)) = Item
       and then Without_Piece (With_Piece (Status, Item)) = Status;

end Theorems.Log_Pieces;
