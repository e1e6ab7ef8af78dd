--  SPDX-License-Identifier: Apache-2.0

--  The transfer of a node's error log to the other node, a byte a message
--  (SAF-7, D-15). A row has 15 fragments: first its number, then the bytes of
--  its words, the high byte first.
--
--  A fragment has 12 bits: the place, 1 to 15, and the byte. 0 is no fragment.
--  The receiver takes a row after all its fragments have come in order. A
--  missed fragment comes again with its row. A row also ends when no fragment
--  comes for some frames: after a gap of 15 fragments another row continues at
--  the expected place.

with URVOS;           use URVOS;
with URV.CORE_Memory; use URV.CORE_Memory;

package URV.Log_Pieces with Pure, SPARK_Mode is

   subtype Piece is Word range 0 .. 16#FFF#;

   No_Piece : constant Piece := 0;

   type Place_Count is range 0 .. 15;
   subtype Place is Place_Count range 1 .. 15;

   --  In a downlink the fragment is in the error/status word, above its four
   --  flags. CORE gets the flags alone

   Piece_Unit : constant Word := 16;

   function With_Piece (Status : Word; Item : Piece) return Word is
     (Status mod Piece_Unit + Item * Piece_Unit)
   with Global => null;

   function Piece_Of (Status : Word) return Piece is (Status / Piece_Unit)
   with Global => null;

   function Without_Piece (Status : Word) return Word is
     (Status mod Piece_Unit)
   with Global => null;

   --  The field at a place after the first, and whether the place holds its
   --  high byte

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

   --  Frames in a row without a fragment. One more than the most ends the row:
   --  half of a row, so that the frames of the nodes need not agree.
   Most_Silent : constant := Place'Last / 2;
   subtype Silent_Count is Place_Count range 0 .. Most_Silent;

   --  The row under reception: its number, the number of its fragments
   --  received, and the frames since the last one.
   type Receiver is record
      Got    : Place_Count    := 0;
      Which  : Log_Row_Number := 1;
      Row    : Log_Row        := No_Errors;
      Silent : Silent_Count   := 0;
   end record;

   --  The row after one more byte.
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

   --  The fragment is the next one of the row under reception.
   function Is_Next (This : Receiver; Item : Piece) return Boolean is
     (This.Got in 1 .. Place'Last - 1
      and then Item / 256 = Word (This.Got) + 1)
   with Global => null;

   --  Takes a fragment, or none. Complete is True after a row's last one. A
   --  fragment out of order ends the row.
   procedure Take
     (This     : in out Receiver;
      Item     : Piece;
      Complete : out Boolean)
   with
     Global => null,
     Post   =>
       Complete = (Is_Next (This'Old, Item) and then This.Got = Place'Last)
       and then This =
         (if Item / 256 = 1
            and then Item mod 256 in Word (Log_Row_Number'First)
                                       .. Word (Log_Row_Number'Last)
          then (Got    => 1,
                Which  => Log_Row_Number (Item mod 256),
                Row    => No_Errors,
                Silent => 0)
          elsif Is_Next (This'Old, Item)
          then (Got    => This'Old.Got + 1,
                Which  => This'Old.Which,
                Row    => Extended
                  (This'Old.Row, This'Old.Got + 1, Item mod 256),
                Silent => 0)
          else (This'Old with delta Got => 0, Silent => 0));

   --  The row under reception after a frame without a fragment.
   function After_Silence (This : Receiver) return Receiver is
     (if This.Silent = Most_Silent then (This with delta Got => 0)
      else (This with delta Silent => This.Silent + 1))
   with Global => null;

end URV.Log_Pieces;
