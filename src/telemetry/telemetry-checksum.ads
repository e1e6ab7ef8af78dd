--  SPDX-License-Identifier: Apache-2.0

--  The checksum of a data message: CRC-8/DARC, polynomial
--  x^8 + x^5 + x^4 + x^3 + 1, first value 0, low bit first, over the header
--  and the data (LNK-3, D-7).
--
--  Bits are taken in their order on the line. Every burst of up to eight data
--  bits therefore changes the checksum, as does every error within one
--  character. docs/link.md lists the errors that it does not detect. The
--  polynomial has no factor x + 1; it would only detect again the errors that
--  parity detects.

package Telemetry.Checksum with Pure, SPARK_Mode is

   --  GNAT 12 crashes when it checks a variant at run time here. The proof
   --  shows that the recursion below ends.
   pragma Assertion_Policy (Subprogram_Variant => Ignore);

   First_Value : constant Byte := 0;

   --  A byte is a polynomial with x^0 in its high bit. A shift to the right
   --  thus multiplies by x, and x^8 equals x^5 + x^4 + x^3 + 1.

   --  Value times x^8, without its part beyond x^7.
   function Times_Kept (Value : Byte) return Byte is
     (Value xor Shift_Right (Value, 3) xor Shift_Right (Value, 4)
      xor Shift_Right (Value, 5))
   with Global => null;

   --  The part of Value times x^8 beyond x^7, divided by x^8.
   function Times_Lost (Value : Byte) return Byte is
     (Shift_Left (Value, 5) xor Shift_Left (Value, 4)
      xor Shift_Left (Value, 3))
   with Global => null;

   --  Value times x^8, modulo the polynomial. Two reductions are enough.
   function Times_X8 (Value : Byte) return Byte is
     (Times_Kept
        (Value xor Times_Lost (Value) xor Times_Lost (Times_Lost (Value))))
   with Global => null;

   --  The checksum after one more byte.
   function Next (Sum : Byte; Data : Byte) return Byte
   with
     Inline,
     Global => null,
     Post   => Next'Result = Times_X8 (Sum xor Data);

   --  The checksum of a header and the first Length bytes of a block. Only
   --  contracts call it; the board computes the sum byte by byte.
   function Of_Message
     (Header : Byte;
      Data   : Block_Data;
      Length : Byte_Count) return Byte
   is
     (if Length = 0 then Next (First_Value, Header)
      else Next (Of_Message (Header, Data, Length - 1), Data (Length)))
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Length);

   --  The checksum depends only on the header and those bytes.
   procedure Same_Bytes_Same_Sum
     (Header      : Byte;
      Left, Right : Block_Data;
      Length      : Byte_Count)
   with
     Ghost,
     Global => null,
     Pre    =>
       (for all I in Byte_Index =>
          (if I <= Length then Left (I) = Right (I))),
     Post   =>
       Of_Message (Header, Left, Length) = Of_Message (Header, Right, Length);

end Telemetry.Checksum;
