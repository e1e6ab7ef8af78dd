--  SPDX-License-Identifier: Apache-2.0

--  How a node's error log goes to the other one, a byte a message (SAF-7,
--  D-15): a row of it in 15 pieces, first its number, then the bytes of its
--  words, the high one first.
--
--  A piece has 12 bits: the place, 1 to 15, and the byte. 0 is no piece.
--  Whoever receives takes a row when all of its pieces have come, one after
--  the other; one that is missed comes again with its row.

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URVOS;               use URVOS;

package URV.Log_Pieces with Pure, SPARK_Mode is

   subtype Piece is Word range 0 .. 16#FFF#;

   No_Piece : constant Piece := 0;

   type Place_Count is range 0 .. 15;
   subtype Place is Place_Count range 1 .. 15;

   --  On the way down a piece stands in the error/status word, above its
   --  four flags. CORE has the flags alone.

   Piece_Unit : constant Word := 16;

   function With_Piece (Status : Word; Item : Piece) return Word is
     (Status mod Piece_Unit + Item * Piece_Unit)
   with Global => null;

   function Piece_Of (Status : Word) return Piece is (Status / Piece_Unit)
   with Global => null;

   function Without_Piece (Status : Word) return Word is
     (Status mod Piece_Unit)
   with Global => null;

   --  The field that a place after the first is of, and whether it is the
   --  field's high byte.

   function Field_At (Where : Place) return Log_Field is
     (Log_Field'Val (Integer (Where) / 2 - 1))
   with
     Global => null,
     Pre    => Where > 1;

   function Is_High (Where : Place) return Boolean is (Where mod 2 = 0)
   with Global => null;

   function Byte_At
     (Which : Log_Row_Number;
      Row   : Log_Row;
      Where : Place) return Word
   is
     (if Where = 1 then Word (Which)
      elsif Is_High (Where) then Row (Field_At (Where)) / 256
      else Row (Field_At (Where)) mod 256)
   with
     Global => null,
     Post   => Byte_At'Result <= 255;

   function Piece_At
     (Which : Log_Row_Number;
      Row   : Log_Row;
      Where : Place) return Piece
   is (Word (Where) * 256 + Byte_At (Which, Row, Where))
   with
     Global => null,
     Post   => Piece_At'Result /= No_Piece;

   --  The row that is coming in: its number, and how many of its pieces have
   --  come.
   type Receiver is record
      Got   : Place_Count    := 0;
      Which : Log_Row_Number := 1;
      Row   : Log_Row        := No_Errors;
   end record;

   --  The row with one more byte.
   function Extended
     (Row   : Log_Row;
      Where : Place;
      Value : Word) return Log_Row
   is
     ((Row with delta
         Field_At (Where) =>
           (if Is_High (Where)
            then Value * 256
            else (Row (Field_At (Where)) and 16#FF00#) or Value)))
   with
     Global => null,
     Pre    => Where > 1 and then Value <= 255;

   --  The piece is the next of the row that is coming in.
   function Is_Next (This : Receiver; What : Piece) return Boolean is
     (This.Got in 1 .. Place'Last - 1
      and then What / 256 = Word (This.Got) + 1)
   with Global => null;

   --  A piece has come, or none. Complete tells that it was the last of a
   --  row. One that is not the next of its row ends the row.
   procedure Take
     (This     : in out Receiver;
      What     : Piece;
      Complete : out Boolean)
   with
     Global => null,
     Post   =>
       Complete = (Is_Next (This'Old, What) and then This.Got = Place'Last)
       and then This =
         (if What / 256 = 1
            and then What mod 256 in Word (Log_Row_Number'First)
                                       .. Word (Log_Row_Number'Last)
          then (Got   => 1,
                Which => Log_Row_Number (What mod 256),
                Row   => No_Errors)
          elsif Is_Next (This'Old, What)
          then (Got   => This'Old.Got + 1,
                Which => This'Old.Which,
                Row   => Extended
                  (This'Old.Row, This'Old.Got + 1, What mod 256))
          else (This'Old with delta Got => 0));

end URV.Log_Pieces;
