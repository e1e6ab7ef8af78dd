--  SPDX-License-Identifier: Apache-2.0

package body Theorems.Link with SPARK_Mode is

   procedure Headers_Are_Far_Apart (Left, Right : Byte) is null;

   procedure Step_Is_Polynomial_Division (Value : Byte) is null;

   procedure Step_Tells_Apart (Left, Right : Byte; Data : Byte) is null;

   procedure Step_Tells_Bursts
     (Sum           : Byte;
      First, Second : Byte;
      Error_1       : Byte;
      Error_2       : Byte;
      Split         : Burst_Split)
   is null;

   procedure One_Wrong_Byte_Is_Detected
     (Header : Byte;
      Sent   : Block_Data;
      Came   : Block_Data;
      Wrong  : Byte_Index;
      Length : Byte_Count)
   is
   begin
      if Wrong = Length then
         Same_Bytes_Same_Sum (Header, Sent, Came, Length - 1);
         Step_Tells_Apart
           (Sent (Length), Came (Length),
            Of_Message (Header, Sent, Length - 1));
      else
         One_Wrong_Byte_Is_Detected (Header, Sent, Came, Wrong, Length - 1);
         Step_Tells_Apart
           (Of_Message (Header, Sent, Length - 1),
            Of_Message (Header, Came, Length - 1),
            Sent (Length));
      end if;
   end One_Wrong_Byte_Is_Detected;

   procedure Wrong_Header_Is_Detected
     (Sent, Came : Byte;
      Data       : Block_Data;
      Length     : Byte_Count)
   is
   begin
      if Length = 0 then
         Step_Tells_Apart (Sent, Came, First_Value);
      else
         Wrong_Header_Is_Detected (Sent, Came, Data, Length - 1);
         Step_Tells_Apart
           (Of_Message (Sent, Data, Length - 1),
            Of_Message (Came, Data, Length - 1),
            Data (Length));
      end if;
   end Wrong_Header_Is_Detected;

end Theorems.Link;
