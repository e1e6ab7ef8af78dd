--  SPDX-License-Identifier: Apache-2.0

with Bench_Times;
with URVOS.Frames;           use URVOS.Frames;
with URVOS.Schedulers;       use URVOS.Schedulers;
with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;
with URVOS.Task_Trees;       use URVOS.Task_Trees;

package body Bench_Scheduler is

   Tasks : Scheduler;
   Now   : Clock_Tick := 0;

   --  Every task sleeps until the next frame, and is woken and chosen again:
   --  a decision is a choice and a sleep.
   procedure Decide (Turn : Positive);

   --  The running task gives way to one of higher priority, which ends its
   --  frame and is woken for the next.
   procedure Give_Way (Turn : Positive);

   generic
      Number : Positive;
   procedure Measure_Tasks;

   procedure Decide (Turn : Positive) is
      pragma Unreferenced (Turn);
   begin
      while not Is_Idle (Tasks) loop
         Sleep (Tasks, Next_Frame (Now));
         Dispatch (Tasks);
      end loop;
      Now := Next_Frame (Now);
      Wake (Tasks, Now);
      Dispatch (Tasks);
   end Decide;

   procedure Give_Way (Turn : Positive) is
      pragma Unreferenced (Turn);
   begin
      Sleep (Tasks, Next_Frame (Now));
      Dispatch (Tasks);
      Now := Next_Frame (Now);
      Wake (Tasks, Now);
      if not Is_Idle (Tasks) then
         Exit_Call (Tasks);
      end if;
   end Give_Way;

   procedure Measure_Tasks is
      procedure Time_Decision is new Bench_Times
        (Decide, "decision" & Number'Image, 4_000 / Number, Each => Number);
      procedure Time_Exit is new Bench_Times
        (Give_Way, "exit" & Number'Image, 1_000);

      Tree : Task_Tree := Empty_Tree;
   begin
      for Which in 1 .. TCB_Number (Number) loop
         Tree (Which) :=
           (Id               => Task_Id (Which),
            Initial_Priority => Priority (Which),
            Start_Time       => 0);
      end loop;
      Now := 0;
      Start (Tasks, Tree, Now);
      Time_Decision;
      Time_Exit;
   end Measure_Tasks;

   procedure Measure is
      procedure Measure_2 is new Measure_Tasks (2);
      procedure Measure_10 is new Measure_Tasks (10);
      procedure Measure_16 is new Measure_Tasks (16);
   begin
      Measure_2;
      Measure_10;
      Measure_16;
   end Measure;

end Bench_Scheduler;
