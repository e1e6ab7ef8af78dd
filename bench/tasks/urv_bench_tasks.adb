--  SPDX-License-Identifier: Apache-2.0

--  What decisions of the scheduler cost with as many tasks as it has TCBs.
--  scripts/bench.py builds it beside copies of the kernel that have fewer and
--  more than the product's 16.

with Bench_Times;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Schedulers;   use URVOS.Schedulers;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;

procedure Urv_Bench_Tasks is

   type Lot is mod 2**32;

   Tree   : Task_Tree;
   Number : constant Positive := Tree'Length;
   Tasks  : Scheduler;
   Now    : Clock_Tick := 0;
   Seed   : Lot := 1;

   --  Time passes until a task runs.
   procedure Wake_Somebody;

   --  Every task sleeps until the next frame, and is woken and chosen again:
   --  a decision is a choice and a sleep.
   procedure Decide (Turn : Positive);

   --  The task that runs sleeps for a time by lot, so that it seldom goes
   --  behind all others.
   procedure Decide_By_Lot (Turn : Positive);

   --  The task that runs gives way to one of higher priority, which ends its
   --  frame and is woken for the next.
   procedure Give_Way (Turn : Positive);

   procedure Wake_Somebody is
   begin
      while Is_Idle (Tasks) loop
         Now := Now + 1;
         Wake (Tasks, Now);
         Dispatch (Tasks);
      end loop;
   end Wake_Somebody;

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

   procedure Decide_By_Lot (Turn : Positive) is
      pragma Unreferenced (Turn);
   begin
      Seed := Seed * 1_103_515_245 + 12_345;
      Sleep (Tasks, Now + 1 + Tick (Seed / 2**16) mod Tick (Number));
      Dispatch (Tasks);
      Wake_Somebody;
   end Decide_By_Lot;

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

   procedure Time_Decision is new Bench_Times
     (Decide, "decision" & Number'Image, 4_000 / Number, Each => Number);
   procedure Time_Scattered is new Bench_Times
     (Decide_By_Lot, "scattered" & Number'Image, 4_000);
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
   Wake_Somebody;
   Time_Scattered;
end Urv_Bench_Tasks;
