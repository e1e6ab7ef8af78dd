--  SPDX-License-Identifier: Apache-2.0

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;

with Bench_Times;
with URVOS;                  use URVOS;
with URVOS.Frames;           use URVOS.Frames;
with URVOS.Schedulers;       use URVOS.Schedulers;
with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;
with URVOS.Semaphores;       use URVOS.Semaphores;
with URVOS.Shared_Mailboxes;
with URVOS.Shared_Semaphores;
with URVOS.Task_Trees;       use URVOS.Task_Trees;

package body Bench_Calls is

   --  A mailbox between two tasks.
   generic
      Length : Positive;
   package Boxes is
      procedure Exchange (Turn : Positive);
   end Boxes;

   package body Boxes is

      type Bytes is array (1 .. Length) of Byte;

      package Shared is
        new URVOS.Shared_Mailboxes (Bytes, Bytes'(others => 0));

      Box  : Shared.Variable;
      Sent : Bytes := (others => 1);
      Got  : Bytes;

      procedure Exchange (Turn : Positive) is
         Success : Boolean;
         Fresh   : Boolean;
      begin
         Sent (1) := Byte (Turn mod 256);
         Box.Send (Sent, Success);
         Box.Receive (Got, Fresh);
         if not Success or else not Fresh or else Got (1) /= Sent (1) then
            raise Program_Error;
         end if;
      end Exchange;

   end Boxes;

   package Boxes_28 is new Boxes (28);
   package Boxes_66 is new Boxes (66);
   package Boxes_1024 is new Boxes (1024);

   Semaphore : URVOS.Shared_Semaphores.Flag;

   There, Back : Suspension_Object;

   task Other;

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

   procedure Exchange_28 (Turn : Positive) renames Boxes_28.Exchange;
   procedure Exchange_66 (Turn : Positive) renames Boxes_66.Exchange;
   procedure Exchange_1024 (Turn : Positive) renames Boxes_1024.Exchange;

   procedure Claim_And_Release (Turn : Positive) is
      pragma Unreferenced (Turn);
      Claimed  : Boolean;
      Released : Boolean;
      Owner    : Claimant;
      Holder   : Task_Id;
   begin
      Semaphore.Try_Claim (1, Claimed, Owner);
      Semaphore.Release (1, Released, Holder);
      if not (Claimed and then Released) then
         raise Program_Error;
      end if;
   end Claim_And_Release;

   task body Other is
   begin
      loop
         Suspend_Until_True (There);
         Set_True (Back);
      end loop;
   end Other;

   procedure There_And_Back (Turn : Positive) is
      pragma Unreferenced (Turn);
   begin
      Set_True (There);
      Suspend_Until_True (Back);
   end There_And_Back;

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

   procedure Measure_Scheduler is
      procedure Measure_2 is new Measure_Tasks (2);
      procedure Measure_10 is new Measure_Tasks (10);
      procedure Measure_16 is new Measure_Tasks (16);
   begin
      Measure_2;
      Measure_10;
      Measure_16;
   end Measure_Scheduler;

end Bench_Calls;
