--  SPDX-License-Identifier: Apache-2.0

with URVOS.Processor_Tests; use URVOS.Processor_Tests;
with URVOS.RAM_Tests;
with URVOS.ROM_Checks;

package body URVOS.Start_Tests with SPARK_Mode is

   package ROM_Check is new URVOS.ROM_Checks (Last_Byte);

   package RAM_Test is new URVOS.RAM_Tests
     (Last  => Last_Word,
      Write => Write_RAM,
      Read  => Read_RAM);

   --  One pass over the whole image.
   procedure Test_ROM (Good : out Boolean);

   procedure Test_ROM (Good : out Boolean) is
      use type ROM_Check.Outcome_Kind;
      State   : ROM_Check.Check := ROM_Check.New_Check;
      Outcome : ROM_Check.Outcome_Kind;
      Data    : Byte;
   begin
      for Where in 0 .. Last_Byte loop
         Read_ROM (Where, Data);
         ROM_Check.Take_Byte (State, Data, Outcome);
         pragma Loop_Invariant
           (if Where < Last_Byte
            then State.Position = Where + 1
              and then Outcome = ROM_Check.Under_Way);
      end loop;
      pragma Unreferenced (State);
      Good := Outcome = ROM_Check.Found_Good;
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
