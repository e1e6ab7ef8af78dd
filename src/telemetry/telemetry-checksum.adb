--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Checksum with SPARK_Mode is

   procedure Same_Bytes_Same_Sum
     (Header      : Byte;
      Left, Right : Block_Data;
      Length      : Byte_Count)
   is
   begin
      if Length > 0 then
         Same_Bytes_Same_Sum (Header, Left, Right, Length - 1);
      end if;
   end Same_Bytes_Same_Sum;

end Telemetry.Checksum;
