--  The checksum of a data message: CRC-8 with polynomial x^8 + x^2 + x + 1,
--  first value 0, over the header and the data (LNK-3, D-7).
--
--  Every error within one character and every burst of up to eight bits
--  changes it: see docs/link.md for what it does not detect.

package Telemetry.Checksum with Pure, SPARK_Mode is

   --  GNAT 12 crashes when it has to check a variant at run time here. That
   --  the recursion below ends is proven.
   pragma Assertion_Policy (Subprogram_Variant => Ignore);

   First_Value : constant Byte := 0;

   --  The two bits that leave a byte at the top when it is multiplied by
   --  x^2 + x + 1.
   function Overflow (Value : Byte) return Byte is
     (Shift_Right (Value, 7) xor Shift_Right (Value, 6));

   --  Value times x^8, modulo the polynomial: as x^8 is x^2 + x + 1 there,
   --  it is a multiplication by that, and once more for the overflow.
   function Times_X8 (Value : Byte) return Byte is
     (Value xor Shift_Left (Value, 1) xor Shift_Left (Value, 2)
      xor Overflow (Value)
      xor Shift_Left (Overflow (Value), 1)
      xor Shift_Left (Overflow (Value), 2));

   --  The checksum after one more byte.
   function Next (Sum : Byte; Data : Byte) return Byte is
     (Times_X8 (Sum xor Data));

   --  The checksum of a header and the first Length bytes of a block. Only
   --  contracts call it: the board sums up byte by byte.
   function Of_Message
     (Header : Byte;
      Data   : Block_Data;
      Length : Byte_Count) return Byte
   is
     (if Length = 0 then Next (First_Value, Header)
      else Next (Of_Message (Header, Data, Length - 1), Data (Length)))
   with
     Subprogram_Variant => (Decreases => Length);

   --  It depends on nothing but the header and those bytes.
   procedure Same_Bytes_Same_Sum
     (Header      : Byte;
      Left, Right : Block_Data;
      Length      : Byte_Count)
   with
     Ghost,
     Global             => null,
     Subprogram_Variant => (Decreases => Length),
     Pre                =>
       (for all I in Byte_Index =>
          (if I <= Length then Left (I) = Right (I))),
     Post               =>
       Of_Message (Header, Left, Length) = Of_Message (Header, Right, Length);

end Telemetry.Checksum;
