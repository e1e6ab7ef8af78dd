--  SPDX-License-Identifier: Apache-2.0

--  Buffers on the wire: each word as two bytes, the high one first, in the
--  order of the buffer's names (BUF-1 to BUF-3, LNK-3).

with URVOS;     use URVOS;
with Telemetry; use Telemetry;

generic
   type Item is (<>);
   type Buffer is array (Item) of Word;
package URV.Word_Codecs with Pure, SPARK_Mode is

   Block_Length : constant Byte_Count :=
     2 * (Item'Pos (Item'Last) - Item'Pos (Item'First) + 1);

   --  The place of a word's high byte.
   function Place (Which : Item) return Byte_Index is
     (Byte_Index (2 * (Item'Pos (Which) - Item'Pos (Item'First)) + 1))
   with
     Global => null,
     Post   => Place'Result < Block_Length;

   function High_Byte (Value : Word) return Byte is (Byte (Value / 256))
   with Global => null;

   function Low_Byte (Value : Word) return Byte is (Byte (Value mod 256))
   with Global => null;

   function To_Word (High, Low : Byte) return Word is
     (Word (High) * 256 + Word (Low))
   with
     Global => null,
     Post   => High_Byte (To_Word'Result) = High
       and then Low_Byte (To_Word'Result) = Low;

   --  The bytes after the last word are zero.
   function Encode (Source : Buffer) return Block_Data
   with
     Global => null,
     Post   =>
       (for all Which in Item =>
          Encode'Result (Place (Which)) = High_Byte (Source (Which))
          and then Encode'Result (Place (Which) + 1) =
                     Low_Byte (Source (Which)))
       and then
         (for all I in Byte_Index =>
            (if I > Block_Length then Encode'Result (I) = 0));

   function Decode (Source : Block_Data) return Buffer
   with
     Global => null,
     Post   =>
       (for all Which in Item =>
          Decode'Result (Which) =
            To_Word (Source (Place (Which)), Source (Place (Which) + 1)));

   --  Decoding restores an encoded buffer.
   procedure Round_Trip (Source : Buffer)
   with
     Ghost,
     Global => null,
     Post   => Decode (Encode (Source)) = Source;

   --  Encoding restores the bytes of a decoded block.
   procedure Round_Trip_Of_Bytes (Source : Block_Data; I : Byte_Index)
   with
     Ghost,
     Global => null,
     Pre    => I <= Block_Length,
     Post   => Encode (Decode (Source)) (I) = Source (I);

end URV.Word_Codecs;
