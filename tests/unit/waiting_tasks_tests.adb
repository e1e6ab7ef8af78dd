with Checks;           use Checks;
with Expect_Value;
with Expectations;     use Expectations;
with URVOS;            use URVOS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Mailboxes;
with URVOS.Receive_Calls;
with URVOS.Schedulers; use URVOS.Schedulers;
with URVOS.Semaphore_Calls;
with URVOS.Semaphores; use URVOS.Semaphores;
with URVOS.Shared_Mailboxes;
with URVOS.Shared_Semaphores;
with URVOS.Task_Trees; use URVOS.Task_Trees;
with Waiting_Rig;      use Waiting_Rig;

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

   --  The processor of both tasks.
   Processor : Scheduler := Empty_Scheduler (0);

   --  The waiting task of priority 5 runs. The other one sleeps with the
   --  semaphore in its hands until a tick, then releases it, sends a
   --  message and ends.
   procedure Begin_Tasks (Wake_Up : Clock_Tick; Its_Priority : Priority);

   --  EXIT of the waiting task, up to where it runs again.
   procedure Schedule;

   Resource_Reports : Count := 0;

   procedure Report_Not_Claimed (Caller, Holder : Claimant);
   procedure Report_Not_Owned (Caller : Claimant; Holder : Task_Id);

   package Resource is new URVOS.Shared_Semaphores;

   package Resource_Calls is new URVOS.Semaphore_Calls
     (Try_Claim          => Resource.Try_Claim,
      Try_Release        => Resource.Release,
      Read_Clock         => Read_Clock,
      Report_Not_Claimed => Report_Not_Claimed,
      Report_Not_Owned   => Report_Not_Owned);

   procedure Claim is new Resource_Calls.Claim (Exit_Processor);

   package Boxes is new URVOS.Mailboxes (Word, 5);

   package Variable is new URVOS.Shared_Mailboxes (Boxes);

   package Variable_Calls is new URVOS.Receive_Calls
     (Message    => Word,
      Look       => Variable.Look,
      Receive    => Variable.Receive,
      Read_Clock => Read_Clock);

   procedure Receive_Within is
     new Variable_Calls.Receive_Within (Exit_Processor);

   --  Who runs, and who has the semaphore.
   procedure Expect_Waiter_Runs (When_It_Was : String);
   procedure Expect_Owner (When_It_Was : String; Expected : Task_Id);

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

   procedure Begin_Tasks (Wake_Up : Clock_Tick; Its_Priority : Priority) is
      Claimed : Boolean;
      Holder  : Claimant;
   begin
      Begin_At (100, Exits_Per_Tick => 1, Others_Run => Schedule'Access);
      Start
        (Processor,
         (1      => (Waiter, 100, 5),
          2      => (Other, Wake_Up, Its_Priority),
          others => Null_Header),
         100);
      Variable.Reset;
      Resource.Reset;
      Resource.Try_Claim (Other, Claimed, Holder);
      Expect ("claimed to begin with", Claimed, True);
      Expect ("holder to begin with", Holder, Other);
      Resource_Reports := 0;
   end Begin_Tasks;

   procedure Schedule is
      Done : Boolean;
   begin
      Wake (Processor, Now);
      Exit_Call (Processor);
      if Id_Of (Processor, Running_TCB (Processor)) = Other then
         Resource_Calls.Release (Other, Done);
         Expect ("released by its owner", Done, True);
         Variable.Send (77, Done);
         Expect ("sent into an empty box", Done, True);
         Terminate_Caller (Processor);
         Dispatch (Processor);
      end if;
      Expect_Waiter_Runs ("after EXIT");
   end Schedule;

   procedure Expect_Waiter_Runs (When_It_Was : String) is
   begin
      Expect
        (When_It_Was & ", who runs",
         Id_Of (Processor, Running_TCB (Processor)), Waiter);
   end Expect_Waiter_Runs;

   procedure Expect_Owner (When_It_Was : String; Expected : Task_Id) is
      Snapshot : Semaphore;
   begin
      Resource.Inspect (Snapshot);
      Expect (When_It_Was & ", owner", Owner (Snapshot), Expected);
   end Expect_Owner;

   procedure Holder_Wakes is
      Claimed : Boolean;
   begin
      for Wake_Up in Clock_Tick range 101 .. 102 loop
         Begin_Tasks (Wake_Up, Its_Priority => 9);
         Claim (Waiter, Claimed);
         Expect ("claimed", Claimed, True);
         Expect ("claimed at", Now, Wake_Up);
         Expect ("reports", Resource_Reports, 0);
         Expect_Owner ("after its V", Waiter);
         Expect_Waiter_Runs ("after its P");
      end loop;
   end Holder_Wakes;

   procedure Holder_Sleeps_On is
      Claimed  : Boolean;
      Released : Boolean;
   begin
      Begin_Tasks (103, Its_Priority => 9);
      Claim (Waiter, Claimed);
      Expect ("claimed", Claimed, False);
      Expect ("gone on at", Now, 102);
      Expect ("reports of the P", Resource_Reports, 1);
      Resource_Calls.Release (Waiter, Released);
      Expect ("released", Released, False);
      Expect ("reports of the V too", Resource_Reports, 2);
      Expect_Owner ("while it sleeps", Other);
      Exit_Processor;
      Expect_Owner ("when it has run", No_Task);
   end Holder_Sleeps_On;

   procedure Lower_Holder is
      Claimed : Boolean;
   begin
      --  EXIT is for those of higher priority only: a holder of a lower one
      --  does not run, and the P goes on without the semaphore.
      for Its_Priority in Priority range 4 .. 5 loop
         Begin_Tasks (101, Its_Priority);
         Claim (Waiter, Claimed);
         Expect ("claimed", Claimed, False);
         Expect ("gone on at", Now, 102);
         Expect ("reports", Resource_Reports, 1);
         Expect_Owner ("all the time", Other);
      end loop;
   end Lower_Holder;

   procedure Producer_Wakes is
      Item  : Word;
      Fresh : Boolean;
   begin
      for Wake_Up in Clock_Tick range 101 .. 105 loop
         Begin_Tasks (Wake_Up, Its_Priority => 9);
         Receive_Within (5, Item, Fresh);
         Expect ("fresh", Fresh, True);
         Expect ("received", Item, 77);
         Expect ("received at", Now, Wake_Up);
         Expect_Waiter_Runs ("after its RECV");
      end loop;
   end Producer_Wakes;

   procedure Producer_Sleeps_On is
      Item  : Word;
      Fresh : Boolean;
      Box   : Boxes.Mailbox;
   begin
      Begin_Tasks (106, Its_Priority => 9);
      Receive_Within (5, Item, Fresh);
      Expect ("fresh", Fresh, False);
      Expect ("received", Item, 5);
      Expect ("gone on at", Now, 105);
      Variable.Inspect (Box);
      Expect ("misses", Boxes.Misses (Box), 1);
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
