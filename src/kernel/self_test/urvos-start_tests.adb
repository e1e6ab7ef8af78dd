--  SPDX-License-Identifier: Apache-2.0

with URVOS.Image_Sums;      use URVOS.Image_Sums;
with URVOS.Processor_Tests; use URVOS.Processor_Tests;
with URVOS.RAM_Models;      use URVOS.RAM_Models;
with URVOS.RAM_Tests;

package body URVOS.Start_Tests with SPARK_Mode is

   package RAM_Test is new URVOS.RAM_Tests
     (Address    => Word_Address,
      First      => 0,
      Last       => Last_Word,
      Step       => 1,
      Write      => Write_RAM,
      Read       => Read_RAM,
      Wide       => Word,
      Wide_Step  => 1,
      Write_Wide => Write_RAM,
      Read_Wide  => Read_RAM);

   --  One pass over the whole image, four longs in each turn of the loop.
   procedure Test_ROM (Good : out Boolean)
   with Pre => (Last_Long + 1) mod 4 = 0;

   procedure Test_ROM (Good : out Boolean) is
      Last  : constant Byte_Address := Byte_Of (Last_Long - 3);
      Where : Byte_Address := 0;
      Sums  : Sum          := First_Value;

      procedure Add (Where : Byte_Address)
      with
        Inline,
        Pre =>
          Where <= Byte_Of (Last_Long)
          and then Where mod Bytes_Per_Long = 0;

      procedure Add (Where : Byte_Address) is
         Data : Long;
      begin
         Read_ROM (Where, Data);
         Sums := Next (Sums, Data);
      end Add;

   begin
      loop
         pragma Loop_Invariant
           (Where <= Last and then Where mod (4 * Bytes_Per_Long) = 0);
         pragma Loop_Variant (Increases => Where);
         Add (Where);
         Add (Where + Bytes_Per_Long);
         Add (Where + 2 * Bytes_Per_Long);
         Add (Where + 3 * Bytes_Per_Long);
         exit when Where > Last - 4 * Bytes_Per_Long;
         Where := Where + 4 * Bytes_Per_Long;
      end loop;
      Good := Sums = Good_Image;
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
