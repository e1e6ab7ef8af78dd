--  SPDX-License-Identifier: Apache-2.0

--  Phase one of every start: the self-test (report, 2.4, 3.1; INI-2, TST-1,
--  TST-2). It tests the ROM first, since every later test depends on the
--  program, then the RAM, then the processor. It ends at the first test that
--  fails.
--
--  A processor restart happens in flight. It tests the processor alone: no
--  memory fault keeps a flying aircraft from its controller (SAF-12, D-34).
--
--  The test destroys the RAM's contents. Data that survives a restart is
--  therefore in another memory than the one that Read_RAM and Write_RAM reach.

with URVOS.Memories;   use URVOS.Memories;
with URVOS.Self_Tests; use URVOS.Self_Tests;
with URVOS.Starts;     use URVOS.Starts;

generic
   --  The last long of the image, whose number of longs is a multiple of four,
   --  and the last word of the RAM.
   Last_Long : Long_Address;
   Last_Word : Word_Address;

   with procedure Read_ROM (Where : Byte_Address; Data : out Long);
   with procedure Read_RAM (Where : Word_Address; Data : out Word);
   with procedure Write_RAM (Where : Word_Address; Data : Word);
package URVOS.Start_Tests with SPARK_Mode is

   procedure Run (Condition : Start_Condition; Result : out Test_Result)
   with
     Post =>
       (if Result.Passed then Result = All_Passed)

       --  A processor restart always reaches phase two.
       and then (if Condition = Processor_Restart then Result.Passed)

       --  Only these can fail in the proof's model: a processor that follows
       --  Ada's rules passes its tests.
       and then
         (if not Result.Passed then Result.Failed in ROM | RAM)
       and then (if Result.Failed /= RAM then Result.Where = 0)
       and then Result.Where <= Last_Word;

end URVOS.Start_Tests;
