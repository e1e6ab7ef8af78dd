--  SPDX-License-Identifier: Apache-2.0

with Checks;           use Checks;
with Expect_Value;
with Expectations;     use Expectations;
with URVOS;            use URVOS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Semaphore_Calls;
with URVOS.Semaphores; use URVOS.Semaphores;
with URVOS.Shared_Semaphores; use URVOS.Shared_Semaphores;
with URVOS.Task_Trees; use URVOS.Task_Trees;
with URVOS.Waits;      use URVOS.Waits;
with Waiting_Rig;      use Waiting_Rig;

separate (Kernel_Suite)
package body Semaphores_Tests is

   --  The tests, in order.
   procedure Every_Claim;
   procedure Every_Release;
   procedure At_Once;
   procedure Two_Ticks;
   procedure Late_Release;
   procedure Stopped_Clock;
   procedure End_Of_Time;
   procedure Own_Claim;
   procedure In_Steps;
   procedure Without_It;
   procedure Another_Claims;
   procedure Two_Tasks;
   procedure Reset;

   Caller : constant Claimant := 1;
   Other  : constant Claimant := 2;
   Third  : constant Claimant := 255;

   procedure Expect is new Expect_Value (Task_Id);

   Resource : Flag;

   --  The number of tries of P.
   Tries : Count := 0;

   --  The reports, and their numbers.
   Not_Claimed, Not_Owned    : Count   := 0;
   Last_Caller, Last_Holder : Task_Id := No_Task;

   procedure Report_Not_Claimed (Who, Holder : Claimant);
   procedure Report_Not_Owned (Who : Claimant; Holder : Task_Id);

   package Calls is new URVOS.Semaphore_Calls
     (Resource           => Resource,
      Report_Not_Claimed => Report_Not_Claimed,
      Report_Not_Owned   => Report_Not_Owned);

   --  P in steps, with an EXIT between two steps.
   procedure Claim (Who : Claimant; Claimed : out Boolean);

   --  A semaphore that is available or this task's, without reports.
   procedure Begin_With (Owner : Task_Id);

   procedure Expect_Owner (When_It_Was : String; Expected : Task_Id);

   --  Expects this outcome of P by Caller.
   procedure Expect_Claim (When_It_Was : String; Expected : Boolean);

   --  Expects this outcome of V.
   procedure Expect_Release
     (When_It_Was : String;
      Who         : Claimant;
      Expected    : Boolean);

   --  The EXIT at which the other task is finished and releases.
   Release_At_Exit : Natural := 0;
   procedure Other_Releases;

   procedure Claim (Who : Claimant; Claimed : out Boolean) is
      Timeout   : Wait := Begun (Now, Calls.Claim_Wait);
      Try_Again : Boolean;
   begin
      loop
         Tries := Tries + 1;
         Calls.Claim_Step (Who, Now, Timeout, Claimed, Try_Again);
         exit when not Try_Again;
         Expect ("reported before its end", Not_Claimed, 0);
         Exit_Processor;
      end loop;
   end Claim;

   procedure Report_Not_Claimed (Who, Holder : Claimant) is
   begin
      Not_Claimed := Not_Claimed + 1;
      Last_Caller := Who;
      Last_Holder := Holder;
   end Report_Not_Claimed;

   procedure Report_Not_Owned (Who : Claimant; Holder : Task_Id) is
   begin
      Not_Owned   := Not_Owned + 1;
      Last_Caller := Who;
      Last_Holder := Holder;
   end Report_Not_Owned;

   procedure Begin_With (Owner : Task_Id) is
      Claimed : Boolean;
      Holder  : Claimant;
   begin
      Resource.Reset;
      if Owner /= No_Task then
         Resource.Try_Claim (Owner, Claimed, Holder);
         Expect ("claimed to begin with", Claimed, True);
         Expect ("holder to begin with", Holder, Owner);
      end if;
      Tries       := 0;
      Not_Claimed := 0;
      Not_Owned   := 0;
   end Begin_With;

   procedure Expect_Owner (When_It_Was : String; Expected : Task_Id) is
   begin
      Expect
        (When_It_Was & ", owner", Owner (Resource.Snapshot), Expected);
   end Expect_Owner;

   procedure Expect_Claim (When_It_Was : String; Expected : Boolean) is
      Claimed : Boolean;
   begin
      Claim (Caller, Claimed);
      Expect (When_It_Was & ", claimed", Claimed, Expected);
      Expect
        (When_It_Was & ", reported", Not_Claimed, (if Expected then 0 else 1));
      if not Expected then
         Expect (When_It_Was & ", reported caller", Last_Caller, Caller);
      end if;
   end Expect_Claim;

   procedure Expect_Release
     (When_It_Was : String;
      Who         : Claimant;
      Expected    : Boolean)
   is
      Before   : constant Count := Not_Owned;
      Released : Boolean;
   begin
      Calls.Release (Who, Released);
      Expect (When_It_Was & ", released", Released, Expected);
      Expect
        (When_It_Was & ", reported", Not_Owned - Before,
         (if Expected then 0 else 1));
      if not Expected then
         Expect (When_It_Was & ", reported caller", Last_Caller, Who);
      end if;
   end Expect_Release;

   procedure Other_Releases is
   begin
      if Exits = Release_At_Exit then
         Expect_Release ("the other task", Other, True);
      end if;
   end Other_Releases;

   procedure Every_Claim is
      Item    : Semaphore;
      Claimed : Boolean;
      Holder  : Claimant;
   begin
      for First in Claimant loop
         for Second in Claimant loop
            Item := Available_Semaphore;
            Expect ("available at first", Is_Available (Item), True);
            Try_Claim (Item, First, Claimed, Holder);
            Expect ("the first claims", Claimed, True);
            Expect ("the first holds", Holder, First);
            Expect ("available then", Is_Available (Item), False);
            Try_Claim (Item, Second, Claimed, Holder);
            Expect ("the second claims", Claimed, False);
            Expect ("the first still holds", Holder, First);
            Expect ("the first still owns", Owner (Item), First);
         end loop;
      end loop;
   end Every_Claim;

   procedure Every_Release is
      Item     : Semaphore;
      Claimed  : Boolean;
      Released : Boolean;
      First    : Claimant;
      Holder   : Task_Id;
      Left     : Task_Id;
   begin
      for Has_It in Task_Id loop
         for Who in Claimant loop
            Item := Available_Semaphore;
            if Has_It /= No_Task then
               Try_Claim (Item, Has_It, Claimed, First);
               Expect ("claimed", Claimed, True);
               Expect ("holder", First, Has_It);
            end if;
            Release (Item, Who, Released, Holder);
            Left := (if Who = Has_It then No_Task else Has_It);
            Expect
              (Who'Image & " releases" & Has_It'Image,
               Released, Who = Has_It);
            Expect
              (Who'Image & " releases" & Has_It'Image & ", holder",
               Holder, Left);
            Expect
              (Who'Image & " releases" & Has_It'Image & ", owner",
               Owner (Item), Left);
         end loop;
      end loop;
   end Every_Release;

   procedure At_Once is
   begin
      Begin_With (No_Task);
      Begin_At (100, Exits_Per_Tick => 4);
      Expect_Claim ("available", True);
      Expect_Owner ("available", Caller);
      Expect_Number ("EXITs", Exits, 0);
      Expect ("tries", Tries, 1);
      Expect_Release ("after it", Caller, True);
      Expect_Owner ("after it", No_Task);
   end At_Once;

   procedure Two_Ticks is
   begin
      for Per_Tick in 1 .. 10 loop
         Begin_With (Other);
         Begin_At (100, Per_Tick);
         Expect_Claim ("never released", False);
         Expect ("reported holder", Last_Holder, Other);
         Expect_Owner ("never released", Other);
         Expect ("the P ended", Now, 102);
         Expect_Number ("EXITs", Exits, 2 * Per_Tick);
         Expect ("tries", Tries, Count (2 * Per_Tick + 1));
      end loop;
   end Two_Ticks;

   procedure Late_Release is
   begin
      --  Eight EXITs are two ticks. The last one ends the wait.
      for Which in 1 .. 8 loop
         Begin_With (Other);
         Begin_At (100, 4, Other_Releases'Access);
         Release_At_Exit := Which;
         Expect_Claim ("released at EXIT" & Which'Image, True);
         Expect_Owner ("released at EXIT" & Which'Image, Caller);
         Expect_Number ("EXITs", Exits, Which);
      end loop;

      Begin_With (Other);
      Begin_At (100, 4, Other_Releases'Access);
      Release_At_Exit := 9;
      Expect_Claim ("released too late", False);
      Expect_Number ("EXITs", Exits, 8);
   end Late_Release;

   procedure Stopped_Clock is
   begin
      Begin_With (Other);
      Begin_At (100, Exits_Per_Tick => 0);
      Expect_Claim ("the clock stands still", False);
      Expect ("the clock", Now, 100);
      Expect ("tries", Tries, 100_001);

      --  The clock stops after one tick.
      Begin_With (Other);
      Begin_At (100, Exits_Per_Tick => 70_000);
      Expect_Claim ("a slow clock", False);
      Expect ("the clock", Now, 102);
      Expect ("tries", Tries, 140_001);
   end Stopped_Clock;

   procedure End_Of_Time is
   begin
      Begin_With (Other);
      Begin_At (Last_Tick, Exits_Per_Tick => 4);
      Expect_Claim ("at the last tick", False);
      Expect ("tries at the last tick", Tries, 1);

      Begin_With (Other);
      Begin_At (Last_Tick - 1, Exits_Per_Tick => 4);
      Expect_Claim ("a tick before", False);
      Expect ("tries a tick before", Tries, 5);

      Begin_With (No_Task);
      Begin_At (Last_Tick, Exits_Per_Tick => 4);
      Expect_Claim ("available at the last tick", True);
   end End_Of_Time;

   procedure Own_Claim is
   begin
      Begin_With (Caller);
      Begin_At (100, Exits_Per_Tick => 4);
      Expect_Claim ("it has it already", False);
      Expect ("reported holder", Last_Holder, Caller);
      Expect ("the P ended", Now, 102);
      Expect_Release ("the first V", Caller, True);
      Expect_Release ("the second V", Caller, False);
      Expect ("reported holder", Last_Holder, No_Task);
   end Own_Claim;

   procedure In_Steps is
      Timeout   : Wait := Begun (100, Calls.Claim_Wait);
      Claimed   : Boolean;
      Try_Again : Boolean;
   begin
      --  In virtual time two steps are one tick apart.
      Begin_With (Other);
      Begin_At (100, Exits_Per_Tick => 1);
      for Step in 1 .. 3 loop
         Calls.Claim_Step (Caller, Now, Timeout, Claimed, Try_Again);
         Expect ("claimed in step" & Step'Image, Claimed, False);
         Expect ("again after step" & Step'Image, Try_Again, Step < 3);
         Expect
           ("reported in step" & Step'Image, Not_Claimed,
            (if Step < 3 then 0 else 1));
         Exit_Processor;
      end loop;

      Begin_With (No_Task);
      Timeout := Begun (Now, Calls.Claim_Wait);
      Calls.Claim_Step (Caller, Now, Timeout, Claimed, Try_Again);
      Expect ("available", Claimed, True);
      Expect ("again when claimed", Try_Again, False);
   end In_Steps;

   procedure Without_It is
   begin
      Begin_With (Other);
      Begin_At (100, Exits_Per_Tick => 1);
      Expect_Claim ("never released", False);
      Expect_Release ("its V", Caller, False);
      Expect ("reported holder", Last_Holder, Other);
      Expect_Owner ("its V", Other);
      Expect_Release ("the owner's V", Other, True);
      Expect_Owner ("the owner's V", No_Task);
   end Without_It;

   procedure Another_Claims is
      Claimed : Boolean;
      Holder  : Claimant;
   begin
      Begin_With (Other);
      Begin_At (100, Exits_Per_Tick => 1);
      Expect_Claim ("never released", False);

      --  While Caller continues without it, other tasks claim and release it.
      Expect_Release ("the owner's V", Other, True);
      Resource.Try_Claim (Third, Claimed, Holder);
      Expect ("a third claims", Claimed, True);
      Expect ("a third holds", Holder, Third);
      Expect_Release ("its V", Caller, False);
      Expect_Owner ("its V", Third);
      Expect ("reported holder", Last_Holder, Third);
   end Another_Claims;

   procedure Two_Tasks is
      Rounds : constant := 50_000;

      Shared : Flag;

      --  Only the semaphore's owner accesses these.
      Inside : Count := 0 with Volatile;
      Total  : Count := 0 with Volatile;
      Broken : Count := 0 with Volatile;

      procedure Work (Who : Claimant);

      procedure Work (Who : Claimant) is
         Done : Natural := 0;
         Good : Boolean;
         Has  : Task_Id;
      begin
         while Done < Rounds loop
            Shared.Try_Claim (Who, Good, Has);
            if Good then
               Inside := Inside + 1;
               Total  := Total + 1;
               if Inside /= 1 or else Has /= Who then
                  Broken := Broken + 1;
               end if;
               Inside := Inside - 1;
               Shared.Release (Who, Good, Has);
               Done := Done + 1;
            else
               delay 0.0;
            end if;
         end loop;
      end Work;
   begin
      declare
         task Worker;

         task body Worker is
         begin
            Work (Other);
         end Worker;
      begin
         Work (Caller);
      end;
      Expect ("claims by both", Total, 2 * Rounds);
      Expect ("both at once", Broken, 0);
   end Two_Tasks;

   procedure Reset is
   begin
      Begin_With (Third);
      Resource.Reset;
      Expect_Owner ("after a reset", No_Task);
      Expect_Release ("of whom had it", Third, False);
   end Reset;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "SEM-1 whoever claims first has it, for any two tasks",
         Every_Claim'Access);
      Add
        (Suite, "SEM-2 only the owner's V releases, for any two tasks",
         Every_Release'Access);
      Add
        (Suite, "SEM-1 an available semaphore is claimed without an EXIT",
         At_Once'Access);
      Add
        (Suite, "SEM-1 a P in vain ends after two ticks and not before",
         Two_Ticks'Access);
      Add
        (Suite, "SEM-1 a V at any EXIT up to the last is in time",
         Late_Release'Access);
      Add
        (Suite, "SEM-1 MBX-5 a P ends when the clock stops",
         Stopped_Clock'Access);
      Add
        (Suite, "SEM-1 MBX-5 at the clock's last tick a P tries once",
         End_Of_Time'Access);
      Add
        (Suite, "SEM-1 a claim of one's own is not available either",
         Own_Claim'Access);
      Add
        (Suite, "SEM-1 a task in steps tries in each, for two ticks",
         In_Steps'Access);
      Add
        (Suite, "SEM-2 after a P in vain the V releases nothing",
         Without_It'Access);
      Add
        (Suite, "SEM-2 nor does it release the claim of a third task",
         Another_Claims'Access);
      Add
        (Suite, "SEM-1 of two tasks one at a time has it",
         Two_Tasks'Access);
      Add (Suite, "INI-8 a reset semaphore is available", Reset'Access);
   end Add_To;

end Semaphores_Tests;
