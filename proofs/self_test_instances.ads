--  The self-test as a node has it, for the proof (TST-1, TST-3). Nothing
--  runs.

with Devices.Memory_Bus; use Devices.Memory_Bus;
with Devices.Shared_RAM;
with Devices.Shared_ROM;
with URVOS;              use URVOS;
with URVOS.Start_Tests;
with URV.Self_Test_Task;

package Self_Test_Instances with SPARK_Mode is

   package ROM is new Devices.Shared_ROM (Board => 1);

   package RAM is new Devices.Shared_RAM (Board => 1);

   package Start_Test is new URVOS.Start_Tests
     (Last_Byte => Last_ROM_Byte,
      Last_Word => Last_RAM_Word,
      Read_ROM  => ROM.Read,
      Read_RAM  => RAM.Read,
      Write_RAM => RAM.Write);

   --  What was last given.
   Good, Bad   : Count := 0;
   Last_Detail : Word  := 0;

   procedure Write_Result (Good_Passes, Bad_Passes : Count)
   with
     Global => (Output => (Good, Bad)),
     Post   => Good = Good_Passes and then Bad = Bad_Passes;

   procedure Report_Failure (Detail : Word)
   with
     Global => (Output => Last_Detail),
     Post   => Last_Detail = Detail;

   package In_Flight is new URV.Self_Test_Task
     (Last           => Last_ROM_Byte,
      Read_ROM       => ROM.Read,
      Write_Result   => Write_Result,
      Report_Failure => Report_Failure);

end Self_Test_Instances;
