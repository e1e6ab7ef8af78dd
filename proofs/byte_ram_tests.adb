--  SPDX-License-Identifier: Apache-2.0

package body Byte_RAM_Tests with SPARK_Mode is

   procedure Write (Where : Byte_Address; Data : Word) is
      pragma Unreferenced (Where);
   begin
      Cell := Data;
   end Write;

   procedure Read (Where : Byte_Address; Data : out Word) is
      pragma Unreferenced (Where);
   begin
      Data := Cell;
   end Read;

   procedure Write_Long (Where : Byte_Address; Data : Long) is
      pragma Unreferenced (Where);
   begin
      Two_Cells := Data;
   end Write_Long;

   procedure Read_Long (Where : Byte_Address; Data : out Long) is
      pragma Unreferenced (Where);
   begin
      Data := Two_Cells;
   end Read_Long;

end Byte_RAM_Tests;
