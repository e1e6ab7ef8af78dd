--  SPDX-License-Identifier: Apache-2.0

--  The words of a block, and its bytes in message format 1: each word as two
--  bytes, the high one first (BUF-1 to BUF-3, LNK-3). URV.Seal_Blocks has the
--  bytes of format 2.

with URVOS;     use URVOS;
with Telemetry; use Telemetry;

package URV.Plain_Blocks with Pure, SPARK_Mode is

   subtype Word_Place is Byte_Count range 1 .. Longest_Block / 2;

   --  Room for the longest block; an uplink's other words are 0.
   type Block_Words is array (Word_Place) of Word
   with Alignment => 2;

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

   --  The bytes of the words up to Last; the others are zero.
   function Encode (Source : Block_Words; Last : Word_Place)
                    return Block_Data
   with
     Global => null,
     Post   =>
       (for all Which in Word_Place =>
          Encode'Result (2 * Which - 1) =
            (if Which <= Last then High_Byte (Source (Which)) else 0)
          and then Encode'Result (2 * Which) =
            (if Which <= Last then Low_Byte (Source (Which)) else 0));

   --  The words up to Last; the others are zero.
   function Decode (Source : Block_Data; Last : Word_Place)
                    return Block_Words
   with
     Global => null,
     Post   =>
       (for all Which in Word_Place =>
          Decode'Result (Which) =
            (if Which <= Last
             then To_Word (Source (2 * Which - 1), Source (2 * Which))
             else 0));

   --  Decoding restores the encoded words.
   procedure Round_Trip (Source : Block_Words; Last : Word_Place)
   with
     Ghost,
     Global => null,
     Post   =>
       (for all Which in Word_Place =>
          Decode (Encode (Source, Last), Last) (Which) =
            (if Which <= Last then Source (Which) else 0));

end URV.Plain_Blocks;
