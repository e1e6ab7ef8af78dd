--  SPDX-License-Identifier: Apache-2.0

--  The first two phases of a start (report, section 3.1; INI-2, D-16, D-22).
--
--  Phase one is the operating system's self-test. Phase two is the
--  controller's routine for the start condition. The return of that routine
--  replaces the report's START call (D-40). In phase three the scheduler loads
--  the tasks. A failed self-test never reaches phase two.

with URVOS.Frames;     use URVOS.Frames;
with URVOS.Self_Tests; use URVOS.Self_Tests;
with URVOS.Starts;     use URVOS.Starts;

generic
   with procedure Test
     (Condition : Start_Condition; Result : out Test_Result);

   --  Records the start condition and the test's result for later analysis.
   with procedure Record_Start
     (Condition : Start_Condition; Result : Test_Result);

   --  The node remains silent, except that this procedure may report why.
   with procedure Refuse;

   with procedure Cold_Start;
   with procedure Warm_Reset;
   with procedure Processor_Restart;

   with procedure Set_Time (Now : Clock_Tick);
package URVOS.Start_Phases with SPARK_Mode is

   --  If Passed is False, no tasks are loaded.
   procedure Run
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

end URVOS.Start_Phases;
