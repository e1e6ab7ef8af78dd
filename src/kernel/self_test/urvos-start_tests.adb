--  SPDX-License-Identifier: Apache-2.0

with URVOS.Image_Sums;      use URVOS.Image_Sums;
with URVOS.Processor_Tests; use URVOS.Processor_Tests;
with URVOS.RAM_Tests;

package body URVOS.Start_Tests with SPARK_Mode is

   package RAM_Test is new URVOS.RAM_Tests
     (Last  => Last_Word,
      Write => Write_RAM,
      Read  => Read_RAM);

   --  One pass over the whole image.
   procedure Test_ROM (Good : out Boolean);

   procedure Test_ROM (Good : out Boolean) is
      Register : Sum := First_Value;
      Data     : Byte;
   begin
      for Where in 0 .. Last_Byte loop
         Read_ROM (Where, Data);
         Register := Next (Register, Data);
      end loop;
      Good := Register = Good_Image;
   end Test_ROM;

   procedure Run (Condition : Start_Condition; Result : out Test_Result) is
      Good  : Boolean;
      Where : Word_Address;
   begin
      if Condition /= Processor_Restart then
         Test_ROM (Good);
         if not Good then
            Result := Failure (ROM);
            return;
         end if;

         RAM_Test.Run (Good, Where);
         if not Good then
            Result := Failure (RAM, Where);
            return;
         end if;
      end if;

      Result := All_Passed;
      for Test in Processor_Test loop
         if not Passes (Test, Known_Operands) then
            Result := Failure (Test);
            return;
         end if;
      end loop;
   end Run;

end URVOS.Start_Tests;
