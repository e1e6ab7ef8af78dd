--  SPDX-License-Identifier: Apache-2.0

with Checks;           use Checks;
with Expect_Value;
with Expectations;     use Expectations;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Schedulers; use URVOS.Schedulers;
with URVOS.Task_Trees; use URVOS.Task_Trees;

with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;

separate (Kernel_Suite)
package body Schedulers_Tests is

   --  The tests, in order.
   procedure Headers_To_TCBs;
   procedure Empty;
   procedure Full;
   procedure Null_Header_Ends;
   procedure Same_Order_As_Headers;
   procedure Sleepers_In_Order_Of_Headers;
   procedure First_Run;
   procedure Exit_With_Nothing_Higher;
   procedure Exit_To_A_Higher;
   procedure Turns_Of_Equals;
   procedure Sleeper_At_Its_Tick;
   procedure Woken_In_Order;
   procedure Woken_Behind_Ready;
   procedure Sleep_Until_The_Past;
   procedure Sleep_For_Ever;
   procedure Terminate_Frees;
   procedure TCBs_Are_Used_In_Turn;
   procedure Late_Start;
   procedure Late_At_The_Start;
   procedure Run_Into_Next_Release;

   procedure Expect is new Expect_Value (Queue_Name);
   procedure Expect is new Expect_Value (Task_Id);
   procedure Expect is new Expect_Value (TCB_Number);

   --  Expects this running task.
   procedure Expect_Running
     (When_It_Was : String; S : Scheduler; Id : Task_Id);

   --  Some headers without any after them.
   type Headers is array (TCB_Number range <>) of Task_Header;

   function Tree_Of (First : Headers) return Task_Tree;

   --  A scheduler that has just started these tasks.
   function Started (First : Headers; Now : Clock_Tick) return Scheduler;

   --  The caller sleeps, then the next task runs.
   procedure Sleep_And_Dispatch (S : in out Scheduler; Until_Tick : Tick);

   procedure Expect_Running
     (When_It_Was : String; S : Scheduler; Id : Task_Id) is
   begin
      Expect (When_It_Was & ": nobody runs", Is_Idle (S), False);
      Expect (When_It_Was & ": runs", TCB (S, Running_TCB (S)).Id, Id);
   end Expect_Running;

   function Tree_Of (First : Headers) return Task_Tree is
      Tree : Task_Tree := Empty_Tree;
   begin
      for I in First'Range loop
         Tree (I) := First (I);
      end loop;
      return Tree;
   end Tree_Of;

   function Started (First : Headers; Now : Clock_Tick) return Scheduler is
      S : Scheduler;
   begin
      Start (S, Tree_Of (First), Now);
      return S;
   end Started;

   procedure Sleep_And_Dispatch (S : in out Scheduler; Until_Tick : Tick) is
   begin
      Sleep (S, Until_Tick);
      Dispatch (S);
   end Sleep_And_Dispatch;

   procedure Headers_To_TCBs is
      S : constant Scheduler :=
        Started
          (((Id => 7, Start_Time => 100, Initial_Priority => 3),
            (Id => 5, Start_Time => 101, Initial_Priority => 9),
            (Id => 9, Start_Time => 40,  Initial_Priority => 4)),
           Now => 100);

      Queues : constant array (TCB_Number) of Queue_Name :=
        (1 => Ready, 2 => Timer, 3 => Running, others => Free);
   begin
      for Which in TCB_Number loop
         Expect
           ("queue of TCB" & Which'Image, Queue_Of (S, Which),
            Queues (Which));
      end loop;
      Expect ("first task", TCB (S, 1).Id, 7);
      Expect ("second task", TCB (S, 2).Id, 5);
      Expect ("third task", TCB (S, 3).Id, 9);
      Expect_Number ("its priority", Integer (TCB (S, 2).Priority), 9);
      Expect ("its start time", TCB (S, 2).Release, 101);
   end Headers_To_TCBs;

   procedure Empty is
      S : Scheduler := Started ((1 .. 0 => Null_Header), Now => 20);
   begin
      for Step in 1 .. 3 loop
         Expect ("idle", Is_Idle (S), True);
         for Which in TCB_Number loop
            Expect
              ("queue of TCB" & Which'Image, Queue_Of (S, Which), Free);
         end loop;
         Wake (S, Advanced (Clock (S)));
         Dispatch (S);
      end loop;
   end Empty;

   procedure Full is
      Tree : Task_Tree;
      S    : Scheduler;
   begin
      for Which in TCB_Number loop
         Tree (Which) :=
           (Id               => Task_Id (Which),
            Start_Time       => 0,
            Initial_Priority => Priority (17 - Which));
      end loop;
      Start (S, Tree, 0);
      Expect ("a free TCB", Has_Free_TCB (S), False);
      for Id in Task_Id range 1 .. 16 loop
         Expect_Running ("turn" & Id'Image, S, Id);
         Terminate_Caller (S);
         Dispatch (S);
      end loop;
      Expect ("idle at the end", Is_Idle (S), True);
   end Full;

   procedure Null_Header_Ends is
      S : constant Scheduler :=
        Started
          (((Id => 1, others => <>),
            Null_Header,
            (Id => 2, Initial_Priority => 5, others => <>)),
           Now => 0);
   begin
      Expect_Running ("after the start", S, 1);
      Expect ("second TCB", Queue_Of (S, 2), Free);
      Expect ("third TCB", Queue_Of (S, 3), Free);
   end Null_Header_Ends;

   procedure Same_Order_As_Headers is
      S : Scheduler :=
        Started
          (((Id => 4, Initial_Priority => 2, others => <>),
            (Id => 3, Initial_Priority => 2, others => <>),
            (Id => 2, Initial_Priority => 2, others => <>),
            (Id => 1, Initial_Priority => 3, others => <>)),
           Now => 0);
   begin
      for Id of Headers'
        ((Id => 1, others => <>), (Id => 4, others => <>),
         (Id => 3, others => <>), (Id => 2, others => <>))
      loop
         Expect_Running ("in turn", S, Id.Id);
         Sleep_And_Dispatch (S, 10);
      end loop;
   end Same_Order_As_Headers;

   procedure Sleepers_In_Order_Of_Headers is
      S : Scheduler :=
        Started
          (((Id => 4, Start_Time => 9, others => <>),
            (Id => 3, Start_Time => 8, others => <>),
            (Id => 2, Start_Time => 9, others => <>),
            (Id => 1, Start_Time => 8, others => <>)),
           Now => 7);
   begin
      Expect ("idle", Is_Idle (S), True);
      Wake (S, 9);
      for Id of Headers'
        ((Id => 3, others => <>), (Id => 1, others => <>),
         (Id => 4, others => <>), (Id => 2, others => <>))
      loop
         Dispatch (S);
         Expect_Running ("in turn", S, Id.Id);
         Terminate_Caller (S);
      end loop;
   end Sleepers_In_Order_Of_Headers;

   procedure First_Run is
      S : Scheduler :=
        Started
          (((Id => 1, Initial_Priority => 1, others => <>),
            (Id => 2, Start_Time => 3, Initial_Priority => 2)),
           Now => 0);
   begin
      Expect ("at the start", TCB (S, 1).First_Run, True);
      Wake (S, 3);
      Exit_Call (S);
      Expect ("after EXIT", TCB (S, 1).First_Run, True);
      Sleep_And_Dispatch (S, 13);
      Expect ("slept", TCB (S, 2).First_Run, False);
      Expect ("again", TCB (S, 1).First_Run, True);
      Sleep_And_Dispatch (S, 20);
      Expect ("slept too", TCB (S, 1).First_Run, False);
   end First_Run;

   procedure Exit_With_Nothing_Higher is
      S : Scheduler :=
        Started
          (((Id => 1, Initial_Priority => 5, others => <>),
            (Id => 2, Initial_Priority => 5, others => <>),
            (Id => 3, Initial_Priority => 4, others => <>),
            (Id => 4, Start_Time => 1, Initial_Priority => 6)),
           Now => 0);
      Before : constant Scheduler := S;
   begin
      Exit_Call (S);
      Expect ("the same state", S = Before, True);
      Expect_Running ("after EXIT", S, 1);
   end Exit_With_Nothing_Higher;

   procedure Exit_To_A_Higher is
      S : Scheduler :=
        Started
          (((Id => 1, Initial_Priority => 5, others => <>),
            (Id => 2, Initial_Priority => 5, others => <>),
            (Id => 3, Initial_Priority => 4, others => <>),
            (Id => 4, Start_Time => 1, Initial_Priority => 6),
            (Id => 5, Start_Time => 1, Initial_Priority => 7)),
           Now => 0);
   begin
      Wake (S, 1);
      Expect_Running ("no preemption", S, 1);
      Exit_Call (S);
      Expect_Running ("after EXIT", S, 5);
      Expect ("the caller is ready", Queue_Of (S, 1), Ready);
      Expect ("behind its equal", Is_Ahead (S, 2, 1), True);
      Expect ("before the lower", Is_Ahead (S, 1, 3), True);

      --  All others in order.
      for Id of Headers'
        ((Id => 4, others => <>), (Id => 2, others => <>),
         (Id => 1, others => <>), (Id => 3, others => <>))
      loop
         Sleep_And_Dispatch (S, 10);
         Expect_Running ("then", S, Id.Id);
      end loop;
   end Exit_To_A_Higher;

   procedure Turns_Of_Equals is
      S : Scheduler :=
        Started
          (((Id => 1, others => <>),
            (Id => 2, others => <>),
            (Id => 3, others => <>)),
           Now => 0);
   begin
      for Now in Clock_Tick range 1 .. 300 loop
         Expect_Running
           ("at" & Now'Image, S, Task_Id ((Now - 1) mod 3 + 1));
         Sleep (S, Now);
         Wake (S, Now);
         Dispatch (S);
      end loop;
   end Turns_Of_Equals;

   procedure Sleeper_At_Its_Tick is
      S : Scheduler := Started ((1 => (Id => 1, others => <>)), Now => 0);
   begin
      Sleep_And_Dispatch (S, 14);
      for Now in Clock_Tick range 1 .. 13 loop
         Wake (S, Now);
         Dispatch (S);
         Expect ("asleep at" & Now'Image, Queue_Of (S, 1), Timer);
      end loop;
      Wake (S, 14);
      Expect ("ready at 14", Queue_Of (S, 1), Ready);
      Dispatch (S);
      Expect_Running ("at 14", S, 1);
   end Sleeper_At_Its_Tick;

   procedure Woken_In_Order is
      --  Four tasks of one priority, and their ticks.
      Ticks : constant array (TCB_Number range 1 .. 4) of Tick :=
        (30, 10, 30, 20);
      Order : constant array (TCB_Number range 1 .. 4) of Task_Id :=
        (2, 4, 1, 3);

      S : Scheduler :=
        Started
          (((Id => 1, others => <>), (Id => 2, others => <>),
            (Id => 3, others => <>), (Id => 4, others => <>)),
           Now => 0);
   begin
      for Until_Tick of Ticks loop
         Sleep_And_Dispatch (S, Until_Tick);
      end loop;
      Expect ("all asleep", Is_Idle (S), True);

      --  The clock was not read for a while.
      Wake (S, 100);
      for Id of Order loop
         Dispatch (S);
         Expect_Running ("woken", S, Id);
         Terminate_Caller (S);
      end loop;
   end Woken_In_Order;

   procedure Woken_Behind_Ready is
      S : Scheduler :=
        Started
          (((Id => 1, Initial_Priority => 9, others => <>),
            (Id => 2, Start_Time => 2, Initial_Priority => 4),
            (Id => 3, Start_Time => 1, Initial_Priority => 4),
            (Id => 4, Initial_Priority => 4, others => <>),
            (Id => 5, Start_Time => 2, Initial_Priority => 5)),
           Now => 0);
   begin
      Wake (S, 2);
      for Id of Headers'
        ((Id => 1, others => <>), (Id => 5, others => <>),
         (Id => 4, others => <>), (Id => 3, others => <>),
         (Id => 2, others => <>))
      loop
         Expect_Running ("in turn", S, Id.Id);
         Sleep_And_Dispatch (S, 10);
      end loop;
   end Woken_Behind_Ready;

   procedure Sleep_Until_The_Past is
   begin
      for Until_Tick in Tick range 0 .. 20 loop
         declare
            S : Scheduler :=
              Started ((1 => (Id => 1, others => <>)), Now => 20);
         begin
            Sleep (S, Until_Tick);
            Expect ("asleep", Queue_Of (S, 1), Timer);
            Expect ("until", TCB (S, 1).Release, 21);
            Wake (S, 20);
            Expect ("the same tick again", Queue_Of (S, 1), Timer);
            Wake (S, 21);
            Expect ("the next tick", Queue_Of (S, 1), Ready);
         end;
      end loop;
   end Sleep_Until_The_Past;

   procedure Sleep_For_Ever is
      S : Scheduler :=
        Started
          (((Id => 1, others => <>), (Id => 2, others => <>)),
           Now => Last_Tick);
   begin
      Sleep_And_Dispatch (S, 0);
      Sleep_And_Dispatch (S, Next_Release (Last_Tick, Minor_Frame'Last));
      for Step in 1 .. 20 loop
         Wake (S, Advanced (Clock (S)));
         Dispatch (S);
         Expect ("nobody is released", Is_Idle (S), True);
      end loop;
   end Sleep_For_Ever;

   procedure Terminate_Frees is
      S : Scheduler :=
        Started
          (((Id => 1, Initial_Priority => 2, others => <>),
            (Id => 2, Initial_Priority => 1, others => <>),
            (Id => 3, Start_Time => 5, Initial_Priority => 1)),
           Now => 0);
   begin
      Terminate_Caller (S);
      Expect ("idle", Is_Idle (S), True);
      Expect ("its TCB", Queue_Of (S, 1), Free);
      Expect ("who was ready", Queue_Of (S, 2), Ready);
      Expect ("who slept", Queue_Of (S, 3), Timer);
      Dispatch (S);
      Expect_Running ("after it", S, 2);
      for Now in Clock_Tick range 1 .. 40 loop
         Wake (S, Now);
         Expect ("at" & Now'Image, Queue_Of (S, 1), Free);
      end loop;
   end Terminate_Frees;

   procedure TCBs_Are_Used_In_Turn is
      S : Scheduler :=
        Started ((1 => (Id => 200, Initial_Priority => 1, others => <>)), 0);
      Next : TCB_Number := 2;
   begin
      Sleep (S, Tick'Last);
      for Which in 1 .. 100 loop
         Expect ("next TCB", Head_Of (S, Free), Next);
         Load (S, (Id => Task_Id (Which), others => <>));
         Dispatch (S);
         Expect_Running ("loaded in flight", S, Task_Id (Which));
         Expect ("in the TCB", Running_TCB (S), Next);
         Terminate_Caller (S);
         Next := (if Next = TCB_Number'Last then 2 else Next + 1);
      end loop;
      Expect ("who slept", Queue_Of (S, 1), Timer);
   end TCBs_Are_Used_In_Turn;

   procedure Late_Start is
      S : Scheduler :=
        Started
          (((Id => 1, Initial_Priority => 1, others => <>),
            (Id => 2, Start_Time => 1, Initial_Priority => 2)),
           Now => 0);
   begin
      Expect ("at the start", Overruns (S), 0);
      Wake (S, 1);
      Sleep_And_Dispatch (S, 10);
      Expect ("at its tick", Overruns (S), 0);
      Wake (S, 5);
      Sleep_And_Dispatch (S, 10);
      Wake (S, 10);
      Dispatch (S);
      Expect_Running ("at 10", S, 2);
      Expect ("at its tick again", Overruns (S), 0);

      --  The other task waits until 11.
      Wake (S, 11);
      Sleep_And_Dispatch (S, 20);
      Expect_Running ("at 11", S, 1);
      Expect ("one tick late", Overruns (S), 1);

      --  After its run, it is not late again when it gives way.
      Wake (S, 20);
      Exit_Call (S);
      Expect_Running ("after EXIT", S, 2);
      Wake (S, 21);
      Sleep_And_Dispatch (S, 30);
      Expect_Running ("at 21", S, 1);
      Expect ("counted once", Overruns (S), 1);
   end Late_Start;

   procedure Late_At_The_Start is
      First : constant Headers :=
        ((Id => 1, Start_Time => 4, Initial_Priority => 1),
         (Id => 2, Start_Time => 4, Initial_Priority => 2),
         (Id => 3, Start_Time => 4, Initial_Priority => 2));
   begin
      for Now in Clock_Tick range 3 .. 6 loop
         declare
            S           : constant Scheduler := Started (First, Now);
            When_It_Was : constant String := "started at" & Now'Image;
         begin
            --  Waiting tasks are counted when they run.
            Expect
              (When_It_Was & ": overruns", Overruns (S),
               (if Now > 4 then 1 else 0));
            for Which in First'Range loop
               Expect
                 (When_It_Was & ":" & Which'Image & " has not run",
                  TCB (S, Which).New_Release, Now < 4 or else Which /= 2);
            end loop;
         end;
      end loop;
   end Late_At_The_Start;

   procedure Run_Into_Next_Release is
   begin
      for Length in Clock_Tick range 0 .. 25 loop
         declare
            S : Scheduler :=
              Started ((1 => (Id => 1, Start_Time => 4, others => <>)), 4);
         begin
            Wake (S, 4 + Length);
            Expect
              ("has overrun after" & Length'Image, Has_Overrun (S),
               Length >= 10);
            Sleep (S, Next_Release (Clock (S), 4));
            Expect
              ("overruns after" & Length'Image, Overruns (S),
               (if Length >= 10 then 1 else 0));
         end;
      end loop;
   end Run_Into_Next_Release;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite,
         "KRN-1 each header fills a TCB, ready if due, else in the timer "
         & "queue", Headers_To_TCBs'Access);
      Add
        (Suite, "KRN-1 an empty task tree starts nothing", Empty'Access);
      Add
        (Suite, "KRN-1 a task tree may use all 16 TCBs", Full'Access);
      Add
        (Suite, "KRN-1 headers after a null header are not loaded",
         Null_Header_Ends'Access);
      Add
        (Suite, "KRN-1 tasks of one priority start in their headers' order",
         Same_Order_As_Headers'Access);
      Add
        (Suite, "KRN-1 KRN-3 tasks of one start time sleep in their headers' "
         & "order", Sleepers_In_Order_Of_Headers'Access);
      Add
        (Suite, "KRN-1 a task's first run lasts until it sleeps",
         First_Run'Access);
      Add
        (Suite, "KRN-2 EXIT with none of a higher priority changes nothing",
         Exit_With_Nothing_Higher'Access);
      Add
        (Suite, "KRN-2 EXIT lets a higher task run, the caller waits behind "
         & "its equals", Exit_To_A_Higher'Access);
      Add
        (Suite, "KRN-2 tasks of one priority take turns",
         Turns_Of_Equals'Access);
      Add
        (Suite, "KRN-3 a sleeper is ready at its tick and not before",
         Sleeper_At_Its_Tick'Access);
      Add
        (Suite, "KRN-3 sleepers wake in the order of their ticks",
         Woken_In_Order'Access);
      Add
        (Suite, "KRN-3 who wakes goes behind the ready ones of its priority",
         Woken_Behind_Ready'Access);
      Add
        (Suite, "KRN-3 SLEEP until a tick that has passed lasts one tick",
         Sleep_Until_The_Past'Access);
      Add
        (Suite, "KRN-3 no task wakes after the clock's last tick",
         Sleep_For_Ever'Access);
      Add
        (Suite, "KRN-4 TERMINATE frees the caller's TCB and no other",
         Terminate_Frees'Access);
      Add
        (Suite, "KRN-4 freed TCBs are used again, in turn",
         TCBs_Are_Used_In_Turn'Access);
      Add
        (Suite, "FRM-4 a task that starts after its tick is counted once",
         Late_Start'Access);
      Add
        (Suite, "FRM-4 of late tasks at the start the one that runs is "
         & "counted", Late_At_The_Start'Access);
      Add
        (Suite, "FRM-4 a task that runs at its next release is counted",
         Run_Into_Next_Release'Access);
   end Add_To;

end Schedulers_Tests;
