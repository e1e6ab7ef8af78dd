--  SPDX-License-Identifier: Apache-2.0

--  The words of a buffer by their places in a block: in the order of the
--  buffer's names (BUF-1, BUF-2).

with Telemetry;        use Telemetry;
with URVOS;            use URVOS;
with URV.Plain_Blocks; use URV.Plain_Blocks;

generic
   type Item is (<>);
   type Buffer is array (Item) of Word;
package URV.Word_Codecs with Pure, SPARK_Mode is

   Words : constant Word_Place :=
     Item'Pos (Item'Last) - Item'Pos (Item'First) + 1;

   --  The bytes of a block with these words.
   Block_Length : constant Byte_Count := 2 * Words;

   function Place (Which : Item) return Word_Place is
     (Word_Place (Item'Pos (Which) - Item'Pos (Item'First) + 1))
   with
     Global => null,
     Post   => Place'Result <= Words;

   function Item_At (Which : Word_Place) return Item is
     (Item'Val (Item'Pos (Item'First) + Integer (Which) - 1))
   with
     Global => null,
     Pre    => Which <= Words,
     Post   => Place (Item_At'Result) = Which;

   --  The words after the last of the buffer are zero.
   function Words_Of (Source : Buffer) return Block_Words
   with
     Global => null,
     Post   =>
       (for all Which in Word_Place =>
          Words_Of'Result (Which) =
            (if Which <= Words then Source (Item_At (Which)) else 0));

   function Buffer_Of (Source : Block_Words) return Buffer
   with
     Global => null,
     Post   =>
       (for all Which in Item =>
          Buffer_Of'Result (Which) = Source (Place (Which)));

   --  In format 1 each word of a buffer arrives.
   procedure Round_Trip (Source : Buffer)
   with
     Ghost,
     Global => null,
     Post   =>
       Buffer_Of (Decode (Encode (Words_Of (Source), Words), Words)) = Source;

end URV.Word_Codecs;
