--  SPDX-License-Identifier: Apache-2.0

--  Up to three wrong bits never turn one header into another. The checksum
--  detects every message with one wrong byte, and every burst of up to eight
--  data bits (D-6, D-7). This holds for all messages of both boards. Several
--  separate wrong bytes may go undetected; see docs/link.md.

with Telemetry;          use Telemetry;
with Telemetry.Checksum; use Telemetry.Checksum;
with Telemetry.Headers;  use Telemetry.Headers;
with URVOS;              use URVOS;

package Theorems.Link with Pure, SPARK_Mode, Ghost is

   --  The number of ones in a byte.
   function Weight (Value : Byte) return Natural is
     ((if (Value and 1) = 0 then 0 else 1)
      + (if (Value and 2) = 0 then 0 else 1)
      + (if (Value and 4) = 0 then 0 else 1)
      + (if (Value and 8) = 0 then 0 else 1)
      + (if (Value and 16) = 0 then 0 else 1)
      + (if (Value and 32) = 0 then 0 else 1)
      + (if (Value and 64) = 0 then 0 else 1)
      + (if (Value and 128) = 0 then 0 else 1));

   --  Two different headers differ in at least four bits.
   procedure Headers_Are_Far_Apart (Left, Right : Byte)
   with
     Global => null,
     Pre    =>
       Is_Valid (Left) and then Is_Valid (Right) and then Left /= Right,
     Post   => Weight (Left xor Right) >= 4;

   --  One step of the division by the polynomial, which the checksum computes.
   function Shifted (Value : Byte) return Byte is
     (if (Value and 1) /= 0
      then Shift_Right (Value, 1) xor 16#9C#
      else Shift_Right (Value, 1));

   subtype Burst_Split is Natural range 1 .. 7;

   procedure Step_Is_Polynomial_Division (Value : Byte)
   with
     Global => null,
     Post   =>
       Times_X8 (Value) =
         Shifted (Shifted (Shifted (Shifted
           (Shifted (Shifted (Shifted (Shifted (Value))))))));

   --  Different sums remain different after the same byte, and the same sum
   --  becomes different after different bytes.
   procedure Step_Distinguishes (Left, Right : Byte; Data : Byte)
   with
     Global => null,
     Pre    => Left /= Right,
     Post   =>
       Next (Left, Data) /= Next (Right, Data)
       and then Next (Data, Left) /= Next (Data, Right);

   --  A burst of up to eight data bits that begins in one byte and ends in the
   --  next: at most the last 8 - Split bits of the first byte on the line, and
   --  the first Split bits of the second.
   procedure Step_Distinguishes_Bursts
     (Sum           : Byte;
      First, Second : Byte;
      Error_1       : Byte;
      Error_2       : Byte;
      Split         : Burst_Split)
   with
     Global => null,
     Pre    =>
       (Error_1 /= 0 or else Error_2 /= 0)
       and then Error_1 mod 2 ** Split = 0
       and then Error_2 < 2 ** Split,
     Post   =>
       Next (Next (Sum, First xor Error_1), Second xor Error_2) /=
         Next (Next (Sum, First), Second);

   --  A message with exactly one wrong byte of data, in any bits, has another
   --  checksum.
   procedure One_Wrong_Byte_Is_Detected
     (Header  : Byte;
      Sent    : Block_Data;
      Arrived : Block_Data;
      Wrong   : Byte_Index;
      Length  : Byte_Count)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Length),
     Pre                =>
       Wrong <= Length
       and then Sent (Wrong) /= Arrived (Wrong)
       and then (for all I in Byte_Index =>
                   (if I /= Wrong then Sent (I) = Arrived (I))),
     Post               =>
       Of_Message (Header, Sent, Length) /=
         Of_Message (Header, Arrived, Length);

   --  A message with a wrong header also has another checksum.
   procedure Wrong_Header_Is_Detected
     (Sent, Arrived : Byte;
      Data          : Block_Data;
      Length        : Byte_Count)
   with
     Global             => null,
     Subprogram_Variant => (Decreases => Length),
     Pre                => Sent /= Arrived,
     Post               =>
       Of_Message (Sent, Data, Length) /= Of_Message (Arrived, Data, Length);

end Theorems.Link;
