--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Link with SPARK_Mode is

   procedure Headers_Are_Far_Apart (Left, Right : Byte) is null;

   procedure Step_Is_Polynomial_Division (Value : Byte) is null;

   procedure Step_Distinguishes (Left, Right : Byte; Data : Byte) is null;

   procedure Step_Distinguishes_Bursts
     (Sum           : Byte;
      First, Second : Byte;
      Error_1       : Byte;
      Error_2       : Byte;
      Split         : Burst_Split)
   is null;

   procedure One_Wrong_Byte_Is_Detected
     (Header  : Byte;
      Sent    : Block_Data;
      Arrived : Block_Data;
      Wrong   : Byte_Index;
      Length  : Byte_Count)
   is
   begin
      if Wrong = Length then
         Same_Bytes_Same_Sum (Header, Sent, Arrived, Length - 1);
         Step_Distinguishes
           (Sent (Length), Arrived (Length),
            Of_Message (Header, Sent, Length - 1));
      else
         One_Wrong_Byte_Is_Detected (Header, Sent, Arrived, Wrong, Length - 1);
         Step_Distinguishes
           (Of_Message (Header, Sent, Length - 1),
            Of_Message (Header, Arrived, Length - 1),
            Sent (Length));
      end if;
   end One_Wrong_Byte_Is_Detected;

   procedure Wrong_Header_Is_Detected
     (Sent, Arrived : Byte;
      Data          : Block_Data;
      Length        : Byte_Count)
   is
   begin
      if Length = 0 then
         Step_Distinguishes (Sent, Arrived, First_Value);
      else
         Wrong_Header_Is_Detected (Sent, Arrived, Data, Length - 1);
         Step_Distinguishes
           (Of_Message (Sent, Data, Length - 1),
            Of_Message (Arrived, Data, Length - 1),
            Data (Length));
      end if;
   end Wrong_Header_Is_Detected;

end Theorems.Link;
