with Checks;                   use Checks;
with Expect_Value;
with Expectations;             use Expectations;
with URVOS;                    use URVOS;
with URVOS.Frames;             use URVOS.Frames;
with URVOS.Guarded_Schedulers; use URVOS.Guarded_Schedulers;
with URVOS.Shared_Schedulers;
with URVOS.Starts;             use URVOS.Starts;
with URVOS.Task_Trees;         use URVOS.Task_Trees;

package body Guarded_Schedulers_Tests is

   --  The tests, in order.
   procedure Turns;
   procedure Steps;
   procedure Late_Release;
   procedure Long_Step;
   procedure Counts_Stay;
   procedure Clock_Runs_Back;
   procedure Idle;
   procedure Request_While_Idle;
   procedure Request_During_Step;
   procedure Failed_Step;

   procedure Expect is new Expect_Value (Task_Id);
   procedure Expect is new Expect_Value (Start_Condition);

   First  : constant Task_Id := 3;
   Second : constant Task_Id := 7;

   --  They sleep until minor frames 0 and 4.
   function Pair (Now : Clock_Tick) return Task_Tree is
     ((First, Now, 9), (Second, Now, 8), others => Null_Header);

   procedure Expect_Orders
     (Todo      : Orders;
      Next      : Task_Id;
      Late      : Task_Id := No_Task;
      Late_Next : Boolean := False);

   --  The clock ticks, and nobody wishes for a start.
   procedure Wake
     (Tasks     : in out Guarded_Scheduler;
      Now       : Clock_Tick;
      Next      : Task_Id;
      Late_Next : Boolean := False);

   --  The running task ends its step.
   procedure Sleep
     (Tasks     : in out Guarded_Scheduler;
      Offset    : Minor_Frame;
      Next      : Task_Id;
      Late      : Task_Id := No_Task;
      Late_Next : Boolean := False);

   --  The clock ticks, and a start is granted instead of a turn.
   procedure Expect_Start
     (Tasks     : in out Guarded_Scheduler;
      Now       : Clock_Tick;
      Condition : Start_Condition);

   --  Both tasks are loaded and have initialised.
   procedure Begin_Pair (Tasks : in out Guarded_Scheduler);

   procedure Expect_Orders
     (Todo      : Orders;
      Next      : Task_Id;
      Late      : Task_Id := No_Task;
      Late_Next : Boolean := False) is
   begin
      Expect ("next", Todo.Next, Next);
      Expect ("late", Todo.Late, Late);
      Expect ("next is late", Todo.Late_Next, Late_Next);
   end Expect_Orders;

   procedure Wake
     (Tasks     : in out Guarded_Scheduler;
      Now       : Clock_Tick;
      Next      : Task_Id;
      Late_Next : Boolean := False)
   is
      Todo    : Orders;
      Granted : Wish;
   begin
      Tasks.Wake (Now, Todo, Granted);
      Expect_Orders (Todo, Next, Late_Next => Late_Next);
      Expect ("a start", Granted.Is_There, False);
   end Wake;

   procedure Sleep
     (Tasks     : in out Guarded_Scheduler;
      Offset    : Minor_Frame;
      Next      : Task_Id;
      Late      : Task_Id := No_Task;
      Late_Next : Boolean := False)
   is
      Todo : Orders;
   begin
      Tasks.End_Step (Offset, False, Todo);
      Expect_Orders (Todo, Next, Late, Late_Next);
   end Sleep;

   procedure Expect_Start
     (Tasks     : in out Guarded_Scheduler;
      Now       : Clock_Tick;
      Condition : Start_Condition)
   is
      Todo    : Orders;
      Granted : Wish;
   begin
      Tasks.Wake (Now, Todo, Granted);
      Expect_Orders (Todo, No_Task);
      Expect ("a start", Granted.Is_There, True);
      Expect ("condition", Granted.Condition, Condition);
   end Expect_Start;

   procedure Begin_Pair (Tasks : in out Guarded_Scheduler) is
      Todo : Orders;
   begin
      Tasks.Start (Pair (0), 0, Todo);
      Expect_Orders (Todo, First);
      Sleep (Tasks, 0, Next => Second);
      Sleep (Tasks, 4, Next => No_Task);
   end Begin_Pair;

   procedure Turns is
      Tasks : Guarded_Scheduler;
   begin
      Begin_Pair (Tasks);
      Wake (Tasks, 9, Next => No_Task);
      Wake (Tasks, 10, Next => First);

      --  It still runs: nobody else is resumed.
      Wake (Tasks, 13, Next => No_Task);
      Wake (Tasks, 14, Next => No_Task);
      Sleep (Tasks, 0, Next => Second);
      Sleep (Tasks, 4, Next => No_Task);
      Wake (Tasks, 20, Next => First);
      Sleep (Tasks, 0, Next => No_Task);
      Wake (Tasks, 24, Next => Second);
      Expect ("overruns", Tasks.Overruns, 0);
      Expect ("clock", Tasks.Now, 24);
   end Turns;

   procedure Steps is
      Tasks     : Guarded_Scheduler;
      Todo      : Orders;
      First_Run : Boolean;
   begin
      Tasks.Start (Pair (0), 0, Todo);
      for Number in 1 .. 2 loop
         Tasks.Begin_Step (First_Run);
         Expect ("initialises", First_Run, True);
         Tasks.End_Step (0, False, Todo);
      end loop;
      Wake (Tasks, 10, Next => First);
      Tasks.Begin_Step (First_Run);
      Expect ("initialises", First_Run, False);
      Tasks.End_Step (0, False, Todo);
      Expect_Orders (Todo, Second);
      Tasks.Begin_Step (First_Run);
      Expect ("initialises", First_Run, False);

      --  After a start both do again.
      Tasks.Start (Pair (20), 20, Todo);
      Tasks.Begin_Step (First_Run);
      Expect ("initialises", First_Run, True);
   end Steps;

   procedure Late_Release is
      Tasks : Guarded_Scheduler;
   begin
      Begin_Pair (Tasks);
      Wake (Tasks, 11, Next => First, Late_Next => True);
      Expect ("overruns", Tasks.Overruns, 1);

      --  The second is late because the first took too long.
      Wake (Tasks, 15, Next => No_Task);
      Sleep (Tasks, 0, Next => Second, Late_Next => True);
      Expect ("overruns", Tasks.Overruns, 2);
   end Late_Release;

   procedure Long_Step is
      Tasks : Guarded_Scheduler;
   begin
      Begin_Pair (Tasks);
      Wake (Tasks, 10, Next => First);
      Wake (Tasks, 19, Next => No_Task);
      Wake (Tasks, 20, Next => No_Task);
      Sleep
        (Tasks, 0, Next => Second, Late => First, Late_Next => True);
      Expect ("overruns", Tasks.Overruns, 2);
   end Long_Step;

   procedure Counts_Stay is
      Tasks : Guarded_Scheduler;
      Todo  : Orders;
   begin
      Begin_Pair (Tasks);
      Wake (Tasks, 11, Next => First, Late_Next => True);
      Tasks.Start (Pair (20), 20, Todo);
      Expect ("overruns", Tasks.Overruns, 1);
      Sleep (Tasks, 0, Next => Second);
      Sleep (Tasks, 0, Next => No_Task);
      Wake (Tasks, 31, Next => First, Late_Next => True);
      Expect ("overruns", Tasks.Overruns, 2);
      Tasks.Start (Empty_Tree, 40, Todo);
      Expect ("overruns", Tasks.Overruns, 2);
   end Counts_Stay;

   procedure Clock_Runs_Back is
      Tasks : Guarded_Scheduler;
   begin
      Begin_Pair (Tasks);
      Wake (Tasks, 10, Next => First);
      Sleep (Tasks, 0, Next => No_Task);
      Wake (Tasks, 3, Next => No_Task);
      Expect ("clock", Tasks.Now, 10);
      Wake (Tasks, 10, Next => No_Task);
      Wake (Tasks, 14, Next => Second);
   end Clock_Runs_Back;

   procedure Idle is
      Tasks     : Guarded_Scheduler;
      Todo      : Orders;
      First_Run : Boolean;
   begin
      Expect ("clock", Tasks.Now, 0);
      Tasks.Begin_Step (First_Run);
      Expect ("initialises", First_Run, False);
      Sleep (Tasks, 0, Next => No_Task);
      Tasks.Start (Empty_Tree, 0, Todo);
      Expect_Orders (Todo, No_Task);
      Wake (Tasks, 10, Next => No_Task);
   end Idle;

   procedure Request_While_Idle is
      Tasks : Guarded_Scheduler;
   begin
      Tasks.Request (Cold_Start);
      Expect_Start (Tasks, 0, Cold_Start);
      Wake (Tasks, 1, Next => No_Task);

      --  Of several wishes the last one counts, and nobody is resumed who
      --  is due.
      Begin_Pair (Tasks);
      Tasks.Request (Processor_Restart);
      Tasks.Request (Warm_Reset);
      Expect_Start (Tasks, 10, Warm_Reset);
      Wake (Tasks, 10, Next => First);
   end Request_While_Idle;

   procedure Request_During_Step is
      Tasks : Guarded_Scheduler;
      Todo  : Orders;
   begin
      --  The step is ended first; the second task does not begin its own.
      Tasks.Start (Pair (0), 0, Todo);
      Tasks.Request (Warm_Reset);
      Wake (Tasks, 1, Next => No_Task);
      Sleep (Tasks, 0, Next => No_Task);
      Expect_Start (Tasks, 2, Warm_Reset);
      Wake (Tasks, 2, Next => Second, Late_Next => True);
   end Request_During_Step;

   procedure Failed_Step is
      Todo : Orders;
   begin
      declare
         Tasks : Guarded_Scheduler;
      begin
         Tasks.Start (Pair (0), 0, Todo);
         Tasks.End_Step (0, True, Todo);
         Expect_Orders (Todo, No_Task);
         Expect_Start (Tasks, 1, Processor_Restart);
         Wake (Tasks, 2, Next => Second, Late_Next => True);
      end;

      --  The same in a node's scheduler, as its Ada tasks and its watchers
      --  see it.
      declare
         package Tasks is new URVOS.Shared_Schedulers;

         Granted   : Wish;
         First_Run : Boolean;
         Number    : Count;
         Now       : Clock_Tick;
      begin
         Tasks.Start (Pair (0), 0, Todo);
         Expect_Orders (Todo, First);
         Tasks.Begin_Step (First_Run);
         Expect ("initialises", First_Run, True);
         Tasks.End_Step (0, True, Todo);
         Expect_Orders (Todo, No_Task);
         Tasks.Wake (1, Todo, Granted);
         Expect_Orders (Todo, No_Task);
         Expect ("a start", Granted.Is_There, True);
         Expect ("condition", Granted.Condition, Processor_Restart);
         Tasks.Wake (2, Todo, Granted);
         Expect_Orders (Todo, Second, Late_Next => True);
         Tasks.End_Step (4, False, Todo);
         Tasks.Request_Start (Warm_Reset);
         Tasks.Wake (9, Todo, Granted);
         Expect ("condition", Granted.Condition, Warm_Reset);
         Tasks.Wake (14, Todo, Granted);
         Expect_Orders (Todo, First, Late_Next => True);
         Tasks.End_Step (0, False, Todo);
         Expect_Orders (Todo, Second);
         Tasks.Inspect_Overruns (Number);
         Expect ("overruns", Number, 2);
         Tasks.Inspect_Clock (Now);
         Expect ("clock", Now, 14);
      end;
   end Failed_Step;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "KRN-3 FRM-3 one task at a time is resumed, at its offset",
         Turns'Access);
      Add
        (Suite, "KRN-1 a task's first step after a start is known as such",
         Steps'Access);
      Add
        (Suite, "FRM-4 a task that is resumed late is told and counted",
         Late_Release'Access);
      Add
        (Suite, "FRM-4 a task that runs into its next release is, too",
         Long_Step'Access);
      Add
        (Suite, "FRM-4 overruns are counted across starts",
         Counts_Stay'Access);
      Add
        (Suite, "FRM-1 a clock that runs back is not believed",
         Clock_Runs_Back'Access);
      Add
        (Suite, "KRN-1 without tasks nobody is resumed",
         Idle'Access);
      Add
        (Suite, "INI-1 a start is granted at the tick after the wish, once",
         Request_While_Idle'Access);
      Add
        (Suite, "INI-1 D-9 a start waits for the end of the step",
         Request_During_Step'Access);
      Add
        (Suite, "KRN-6 a failed step brings a processor restart",
         Failed_Step'Access);
   end Add_To;

end Guarded_Schedulers_Tests;
