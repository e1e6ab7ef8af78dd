--  SPDX-License-Identifier: Apache-2.0

with Checks;                  use Checks;
with Expect_Value;
with Expectations;            use Expectations;
with URVOS;                   use URVOS;
with URVOS.Executives;
with URVOS.Frames;            use URVOS.Frames;
with URVOS.Kernel_Calls;      use URVOS.Kernel_Calls;
with URVOS.Receive_Calls;
with URVOS.Semaphore_Calls;
with URVOS.Semaphores;        use URVOS.Semaphores;
with URVOS.Shared_Mailboxes;
with URVOS.Shared_Semaphores; use URVOS.Shared_Semaphores;
with URVOS.Task_Trees;        use URVOS.Task_Trees;
with URVOS.Waits;             use URVOS.Waits;

separate (Kernel_Suite)
package body Waiting_Tasks_Tests is

   --  The tests, in order.
   procedure Holder_Wakes;
   procedure Holder_Sleeps_On;
   procedure Lower_Holder;
   procedure Producer_Wakes;
   procedure Producer_Sleeps_On;

   Waiter : constant Claimant := 1;
   Other  : constant Claimant := 2;

   procedure Expect is new Expect_Value (Task_Id);

   --  The processor of both tasks

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   procedure Report_Overrun (Who : Task_Id) is null;

   procedure Read_Clock
     (Now : in out Clock_Tick; Has_Moved : in out Boolean);

   package Executive is
     new URVOS.Executives (Step, Report_Overrun, Read_Clock);

   --  The clock. It ticks whenever the waiting task has called EXIT.
   Time : Clock_Tick := 0;

   --  The waiting task's activity. After it the task ends.
   type Activity is (Claiming, Receiving, Done);
   Doing   : Activity := Done;
   Timeout : Wait;

   --  The result: the tick of its end, and the semaphore's owner then, before
   --  its V.
   Ended_At  : Clock_Tick := 0;
   Claimed   : Boolean    := False;
   Owner_Was : Task_Id    := No_Task;
   Released  : Boolean    := False;
   Item      : Word       := 0;
   Fresh     : Boolean    := False;

   --  The steps of the waiting task, and the tick of the other task.
   Steps     : Natural    := 0;
   Other_Ran : Clock_Tick := 0;

   --  The waiting task has priority 5. The other one sleeps until a tick while
   --  it holds the semaphore, then releases it, sends a message and ends.
   procedure Run_Tasks
     (What         : Activity;
      Wake_Up      : Clock_Tick;
      Its_Priority : Priority);

   Resource_Reports : Count := 0;

   procedure Report_Not_Claimed (Caller, Holder : Claimant);
   procedure Report_Not_Owned (Caller : Claimant; Holder : Task_Id);

   Resource : Flag;

   package Resource_Calls is new URVOS.Semaphore_Calls
     (Resource           => Resource,
      Report_Not_Claimed => Report_Not_Claimed,
      Report_Not_Owned   => Report_Not_Owned);

   package Messages is new URVOS.Shared_Mailboxes (Word, 5);

   Variable : Messages.Variable;

   package Variable_Calls is new URVOS.Receive_Calls (Messages, Variable);

   --  A step of the waiting task, and whether it continues.
   procedure Wait_Step (Now : Clock_Tick; Goes_On : out Boolean);

   procedure Give_Back;

   procedure Report_Not_Claimed (Caller, Holder : Claimant) is
   begin
      Expect ("whose P was in vain", Caller, Waiter);
      Expect ("who had the semaphore", Holder, Other);
      Resource_Reports := Resource_Reports + 1;
   end Report_Not_Claimed;

   procedure Report_Not_Owned (Caller : Claimant; Holder : Task_Id) is
   begin
      Expect ("whose V was in vain", Caller, Waiter);
      Expect ("who has the semaphore", Holder, Other);
      Resource_Reports := Resource_Reports + 1;
   end Report_Not_Owned;

   procedure Wait_Step (Now : Clock_Tick; Goes_On : out Boolean) is
   begin
      Steps := Steps + 1;
      case Doing is
         when Claiming =>
            Resource_Calls.Claim_Step
              (Waiter, Now, Timeout, Claimed, Goes_On);
            if not Goes_On then
               Owner_Was := Owner (Resource.Snapshot);
               Resource_Calls.Release (Waiter, Released);
            end if;

         when Receiving =>
            Variable_Calls.Receive_Step
              (Now, Timeout, Item, Fresh, Goes_On);

         when Done =>
            Expect ("it has ended", False, True);
      end case;
      if not Goes_On then
         Doing := Done;
         Ended_At := Now;
      end if;
   end Wait_Step;

   procedure Give_Back is
      Success : Boolean;
   begin
      Resource_Calls.Release (Other, Success);
      Expect ("released by its owner", Success, True);
      Variable.Send (77, Success);
      Expect ("sent into an empty box", Success, True);
   end Give_Back;

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call)
   is
      pragma Unreferenced (First_Run);
      Goes_On : Boolean := False;
   begin
      if Who = Waiter then
         Wait_Step (Now, Goes_On);
         if Goes_On then
            Time := Advanced (Time);
         end if;
      else
         Give_Back;
         Other_Ran := Now;
      end if;
      Call :=
        (Name => (if Goes_On then Exit_Call else Terminate_Call),
         others => <>);
   end Step;

   procedure Read_Clock
     (Now : in out Clock_Tick; Has_Moved : in out Boolean) is
   begin
      Now := Time;
      Has_Moved := True;
   end Read_Clock;

   procedure Run_Tasks
     (What         : Activity;
      Wake_Up      : Clock_Tick;
      Its_Priority : Priority)
   is
      Success : Boolean;
      Holder  : Claimant;
   begin
      Time := 100;
      Steps := 0;
      Other_Ran := 0;
      Doing := What;
      Timeout :=
        Begun (100, (if What = Claiming then Resource_Calls.Claim_Wait
                     else 5));
      Variable.Reset;
      Resource.Reset;
      Resource.Try_Claim (Other, Success, Holder);
      Expect ("claimed to begin with", Success, True);
      Expect ("holder to begin with", Holder, Other);
      Resource_Reports := 0;

      Executive.Start
        (((Waiter, 100, 5), (Other, Wake_Up, Its_Priority),
          others => Null_Header),
         100);
      for Number in 1 .. 100 loop
         exit when Doing = Done;
         declare
            Unused_Runs_On : Boolean;
         begin
            Executive.Run_Step (Unused_Runs_On);
         end;
      end loop;
      Expect ("the wait has ended", Doing = Done, True);
   end Run_Tasks;

   procedure Holder_Wakes is
   begin
      for Wake_Up in Clock_Tick range 101 .. 102 loop
         Run_Tasks (Claiming, Wake_Up, Its_Priority => 9);
         Expect ("claimed", Claimed, True);
         Expect ("the other has run at", Other_Ran, Wake_Up);
         Expect ("claimed at", Ended_At, Wake_Up);
         Expect_Number ("steps", Steps, Integer (Wake_Up) - 99);
         Expect ("after the other's V", Owner_Was, Waiter);
         Expect ("its own V", Released, True);
         Expect ("reports", Resource_Reports, 0);
      end loop;
   end Holder_Wakes;

   procedure Holder_Sleeps_On is
   begin
      Run_Tasks (Claiming, 103, Its_Priority => 9);
      Expect ("claimed", Claimed, False);
      Expect ("gone on at", Ended_At, 102);
      Expect ("released", Released, False);
      Expect ("reports of the P and of the V", Resource_Reports, 2);
      Expect ("while it sleeps", Owner (Resource.Snapshot), Other);
      Executive.Clock_Interrupt (103);
      Executive.Run_Until_Idle;
      Expect ("the other has run at", Other_Ran, 103);
      Expect ("when it has run", Owner (Resource.Snapshot), No_Task);
   end Holder_Sleeps_On;

   procedure Lower_Holder is
   begin
      --  EXIT serves only tasks of higher priority: a holder of a lower one
      --  does not run, and the P continues without the semaphore.
      for Its_Priority in Priority range 4 .. 5 loop
         Run_Tasks (Claiming, 101, Its_Priority);
         Expect ("claimed", Claimed, False);
         Expect ("gone on at", Ended_At, 102);
         Expect ("the other has run at", Other_Ran, 0);
         Expect ("reports of the P and of the V", Resource_Reports, 2);
         Expect ("all the time", Owner_Was, Other);

         --  It runs after the waiting task has ended.
         Executive.Run_Until_Idle;
         Expect ("the other has run at", Other_Ran, 102);
      end loop;
   end Lower_Holder;

   procedure Producer_Wakes is
   begin
      for Wake_Up in Clock_Tick range 101 .. 105 loop
         Run_Tasks (Receiving, Wake_Up, Its_Priority => 9);
         Expect ("fresh", Fresh, True);
         Expect ("received", Item, 77);
         Expect ("received at", Ended_At, Wake_Up);
         Expect_Number ("steps", Steps, Integer (Wake_Up) - 99);
         Expect
           ("misses", Messages.Boxes.Misses (Variable.Snapshot), 0);
      end loop;
   end Producer_Wakes;

   procedure Producer_Sleeps_On is
   begin
      Run_Tasks (Receiving, 106, Its_Priority => 9);
      Expect ("fresh", Fresh, False);
      Expect ("received", Item, 5);
      Expect ("gone on at", Ended_At, 105);
      Expect ("misses", Messages.Boxes.Misses (Variable.Snapshot), 1);
   end Producer_Sleeps_On;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "SEM-1 KRN-2 EXIT lets a holder of higher priority run",
         Holder_Wakes'Access);
      Add
        (Suite, "SEM-1 SEM-2 a holder that sleeps too long keeps it",
         Holder_Sleeps_On'Access);
      Add
        (Suite, "SEM-1 KRN-2 a holder of no higher priority does not run",
         Lower_Holder'Access);
      Add
        (Suite, "MBX-3 KRN-2 EXIT lets a producer of higher priority run",
         Producer_Wakes'Access);
      Add
        (Suite, "MBX-3 a producer that sleeps too long is one miss",
         Producer_Sleeps_On'Access);
   end Add_To;

end Waiting_Tasks_Tests;
