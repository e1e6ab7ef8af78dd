--  SPDX-License-Identifier: Apache-2.0

--  The first two phases of a start (report, section 3.1; INI-2, D-16, D-22).
--
--  Phase one is the operating system's self-test. Phase two is one of the
--  controller's routines, one for each start condition. That it returns stands
--  for the report's START call (D-40): phase three, the loading of its tasks,
--  is the scheduler's. A failed self-test never reaches phase two.

with URVOS.Frames;     use URVOS.Frames;
with URVOS.Self_Tests; use URVOS.Self_Tests;
with URVOS.Starts;     use URVOS.Starts;

generic
   with procedure Test
     (Condition : Start_Condition; Result : out Test_Result);

   --  What the start was and what its test found, for later analysis.
   with procedure Record_Start
     (Condition : Start_Condition; Result : Test_Result);

   --  The node stays silent: what it can say of that.
   with procedure Refuse;

   with procedure Cold_Start;
   with procedure Warm_Reset;
   with procedure Processor_Restart;

   with procedure Set_Time (Now : Clock_Tick);
package URVOS.Start_Phases with SPARK_Mode is

   --  Passed tells whether there are tasks to be loaded.
   procedure Run
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

end URVOS.Start_Phases;
