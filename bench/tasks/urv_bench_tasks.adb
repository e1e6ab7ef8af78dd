--  SPDX-License-Identifier: Apache-2.0

--  What decisions of the scheduler cost with as many tasks as it has TCBs.
--  scripts/bench.py builds it beside copies of the kernel that have fewer and
--  more than the product's 16.

with Bench_Times;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Schedulers;   use URVOS.Schedulers;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

procedure Urv_Bench_Tasks is

   Tree  : Task_Tree;
   Tasks : Scheduler;
   Now   : Clock_Tick := 0;

   --  Every task sleeps until the next frame, and is woken and chosen again:
   --  a decision is a choice and a sleep.
   procedure Decide (Turn : Positive);

   --  The task that runs gives way to one of higher priority, which ends its
   --  frame and is woken for the next.
   procedure Give_Way (Turn : Positive);

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

   Number : constant Positive := Tree'Length;

   procedure Time_Decision is new Bench_Times
     (Decide, "decision" & Number'Image, 4_000 / Number, Each => Number);
   procedure Time_Exit is new Bench_Times
     (Give_Way, "exit" & Number'Image, 1_000);
begin
   for Which in Tree'Range loop
      Tree (Which) :=
        (Id               => Task_Id (Which),
         Initial_Priority => Priority (Natural (Which) mod 32),
         Start_Time       => 0);
   end loop;
   Start (Tasks, Tree, 0);
   Time_Decision;
   Time_Exit;
end Urv_Bench_Tasks;
