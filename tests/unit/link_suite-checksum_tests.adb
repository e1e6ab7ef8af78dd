--  SPDX-License-Identifier: Apache-2.0

with Checks;             use Checks;
with Expectations;       use Expectations;
with URVOS;              use URVOS;
with Telemetry;          use Telemetry;
with Telemetry.Checksum; use Telemetry.Checksum;

separate (Link_Suite)
package body Checksum_Tests is

   --  The tests, in order.
   procedure Known_Answer;
   procedure Every_Step;
   procedure Every_Burst;

   --  The division by the polynomial x^8 + x^5 + x^4 + x^3 + 1,
   --  bit by bit, low bit first.
   function By_Division (Data : Byte_Array) return Byte;

   --  The checksum of some bytes, as a board computes it.
   function By_Board (Data : Byte_Array) return Byte;

   --  A message of the longest kind: header, data, and then its checksum.
   subtype Message is Byte_Array (Byte_Index);

   Sample : Message;

   function By_Division (Data : Byte_Array) return Byte is
      Sum : Byte := 0;
   begin
      for Value of Data loop
         Sum := Sum xor Value;
         for Bit in 1 .. 8 loop
            Sum := (if Sum mod 2 = 1 then (Sum / 2) xor 16#9C# else Sum / 2);
         end loop;
      end loop;
      return Sum;
   end By_Division;

   function By_Board (Data : Byte_Array) return Byte is
      Sum : Byte := First_Value;
   begin
      for Value of Data loop
         Sum := Next (Sum, Value);
      end loop;
      return Sum;
   end By_Board;

   procedure Known_Answer is
      --  The catalogues' check value of this CRC: the checksum of the digits 1
      --  to 9 in ASCII.
      Digits_1_To_9 : constant Byte_Array (1 .. 9) :=
        (16#31#, 16#32#, 16#33#, 16#34#, 16#35#, 16#36#, 16#37#, 16#38#,
         16#39#);
   begin
      Expect ("check value", By_Board (Digits_1_To_9), 16#15#);
   end Known_Answer;

   procedure Every_Step is
   begin
      for Sum in Byte loop
         for Data in Byte loop
            Expect
              ("sum" & Sum'Image & ", data" & Data'Image, Next (Sum, Data),
               By_Division ((1 => Sum xor Data)));
         end loop;
      end loop;
   end Every_Step;

   procedure Every_Burst is
      Right : constant Byte := By_Board (Sample);

      --  Errors within two neighbouring bytes; the checksum is the last byte.
      --  The mask's low byte is first on the line, with its low bit first.
      procedure Try (First : Byte_Index; Mask : Word);

      procedure Try (First : Byte_Index; Mask : Word) is
         Wrong : Message := Sample;
         Sum   : Byte := Right;
      begin
         Wrong (First) := Wrong (First) xor Byte (Mask mod 256);
         if First = Message'Last then
            Sum := Sum xor Byte (Mask / 256);
         else
            Wrong (First + 1) := Wrong (First + 1) xor Byte (Mask / 256);
         end if;
         Expect ("the checksum matches", By_Board (Wrong) = Sum, False);
      end Try;

   begin
      --  Bursts of up to eight bits from any bit of any byte.
      for First in Message'Range loop
         for Shift in 0 .. 7 loop
            for Burst in Word range 1 .. 255 loop
               if Burst mod 2 = 1 then
                  Try (First, Burst * 2 ** Shift);
               end if;
            end loop;
         end loop;
      end loop;
   end Every_Burst;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      for I in Sample'Range loop
         Sample (I) := 37 * Byte (I) + 16#87#;
      end loop;
      Add
        (Suite, "D-7 the checksum of the digits 1 to 9 is 15h",
         Known_Answer'Access);
      Add
        (Suite, "D-7 a step of the checksum is a division, for all values",
         Every_Step'Access);
      Add
        (Suite, "D-7 no burst of up to 8 bits leaves the checksum right",
         Every_Burst'Access);
   end Add_To;

end Checksum_Tests;
