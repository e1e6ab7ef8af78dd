--  SPDX-License-Identifier: Apache-2.0

with Checks;             use Checks;
with Expect_Value;
with Expectations;       use Expectations;
with URVOS;              use URVOS;
with URVOS.Executives;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

separate (Kernel_Suite)
package body Clocked_Executives_Tests is

   --  The tests, in order.
   procedure Turns;
   procedure First_Steps;
   procedure Late_Release;
   procedure Long_Step;
   procedure Late_By_An_Exit;
   procedure Exits_In_Time;
   procedure Next_Releases;
   procedure Sleeps;
   procedure Any_Minor_Frame;
   procedure Counts_Stay;
   procedure Clock_Runs_Back;
   procedure Idle;
   procedure Last_Ticks;

   First  : constant Task_Id := 3;
   Second : constant Task_Id := 7;
   Polite : constant Task_Id := 9;

   procedure Expect is new Expect_Value (Task_Id);

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   procedure Report_Overrun (Who : Task_Id);

   procedure Read_Clock
     (Now : in out Clock_Tick; Has_Moved : in out Boolean);

   package Executive is
     new URVOS.Executives (Step, Report_Overrun, Read_Clock);

   --  The hardware's clock, and the number of ticks that the next step takes.
   Time  : Clock_Tick := 0;
   Takes : Tick       := 0;

   --  The last step that ran: its task and the tick of its beginning.
   Ran           : Task_Id    := No_Task;
   Was_First_Run : Boolean    := False;
   Began         : Clock_Tick := 0;

   --  The call that ends the first task's next step, by default until its next
   --  frame.
   First_Call : Kernel_Call := (Name => Next_Frame_Call, others => <>);

   --  The tasks that have overrun since the last look, in order.
   type Id_List is array (Positive range <>) of Task_Id;
   Nobody  : constant Id_List := (1 .. 0 => No_Task);
   Told    : Id_List (1 .. 10);
   Reports : Natural := 0;

   --  The first and the second task sleep until minor frames 0 and 4.
   function Pair (Now : Clock_Tick) return Task_Tree is
     ((First, Now, 9), (Second, Now, 8), others => Null_Header);

   function Alone (Now : Clock_Tick) return Task_Tree is
     (1 => (First, Now, 9), others => Null_Header);

   --  Loads the pair at tick 0 and runs its initialisations.
   procedure Begin_Pair;

   --  The clock ticks.
   procedure Wake (Now : Clock_Tick);

   --  Runs a step, which must be this task's at this tick.
   procedure Run (Who : Task_Id; At_Tick : Clock_Tick; Ticks : Tick := 0);

   procedure Expect_Idle (What : String);

   procedure Expect_Late (What : String; Expected : Id_List);

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call) is
   begin
      Ran := Who;
      Was_First_Run := First_Run;
      Began := Now;
      Time := Time + Takes;
      Call :=
        (if Who = First then First_Call
         elsif Who = Second then (Next_Frame_Call, Offset => 4, others => <>)
         else (Name => Exit_Call, others => <>));
   end Step;

   procedure Report_Overrun (Who : Task_Id) is
   begin
      Reports := Reports + 1;
      Told (Reports) := Who;
   end Report_Overrun;

   procedure Read_Clock
     (Now : in out Clock_Tick; Has_Moved : in out Boolean) is
   begin
      Now := Time;
      Has_Moved := True;
   end Read_Clock;

   procedure Begin_Pair is
   begin
      First_Call := (Next_Frame_Call, Offset => 0, others => <>);
      Reports := 0;
      Time := 0;
      Executive.Start (Pair (0), 0);
      Run (First, At_Tick => 0);
      Run (Second, At_Tick => 0);
      Expect_Idle ("initialised");
   end Begin_Pair;

   procedure Wake (Now : Clock_Tick) is
   begin
      Time := Now;
      Executive.Clock_Interrupt (Now);
   end Wake;

   procedure Run (Who : Task_Id; At_Tick : Clock_Tick; Ticks : Tick := 0) is
      Runs_On : Boolean;
   begin
      Expect ("somebody is to run", Executive.Is_Idle, False);
      Takes := Ticks;
      Executive.Run_Step (Runs_On);
      Expect ("who runs", Ran, Who);
      Expect ("when it runs", Began, At_Tick);
   end Run;

   procedure Expect_Idle (What : String) is
      Runs_On : Boolean;
   begin
      Expect (What & ", idle", Executive.Is_Idle, True);
      Ran := No_Task;
      Executive.Run_Step (Runs_On);
      Expect (What & ", who runs", Ran, No_Task);
      Expect (What & ", runs on", Runs_On, False);
   end Expect_Idle;

   procedure Expect_Late (What : String; Expected : Id_List) is
   begin
      Expect_Number (What & ", overruns told", Reports, Expected'Length);
      for Place in Expected'Range loop
         Expect (What & ", overrun", Told (Place), Expected (Place));
      end loop;
      Reports := 0;
   end Expect_Late;

   procedure Turns is
      Before : Count;
   begin
      Begin_Pair;
      Before := Executive.Overruns;
      Wake (9);
      Expect_Idle ("before the frame");
      Wake (10);

      --  While it runs no other task does. The second task is due when the
      --  first one's step ends.
      Run (First, At_Tick => 10, Ticks => 4);
      Run (Second, At_Tick => 14);
      Expect_Idle ("both have run");
      Wake (20);
      Run (First, At_Tick => 20);
      Expect_Idle ("the first has run");
      Wake (23);
      Expect_Idle ("a tick before the second");
      Wake (24);
      Run (Second, At_Tick => 24, Ticks => 5);
      Expect_Idle ("both have run again");
      Wake (30);
      Run (First, At_Tick => 30);
      Expect_Late ("all in time", Nobody);
      Expect ("overruns", Executive.Overruns, Before);
   end Turns;

   procedure First_Steps is
   begin
      Begin_Pair;
      Executive.Start (Pair (0), 0);
      Run (First, At_Tick => 0);
      Expect ("the first initialises", Was_First_Run, True);
      Run (Second, At_Tick => 0);
      Expect ("the second initialises", Was_First_Run, True);
      Wake (10);
      Run (First, At_Tick => 10, Ticks => 4);
      Expect ("the first initialises again", Was_First_Run, False);
      Run (Second, At_Tick => 14);
      Expect ("the second initialises again", Was_First_Run, False);

      --  After a start both run, whichever ran before.
      Executive.Start (Pair (20), 20);
      Time := 20;
      Run (First, At_Tick => 20);
      Expect ("initialises after a start", Was_First_Run, True);
      Executive.Start (Pair (20), 20);
      for Who of Id_List'(First, Second) loop
         Run (Who, At_Tick => 20);
         Expect ("initialises after one more", Was_First_Run, True);
      end loop;
   end First_Steps;

   procedure Late_Release is
      Before : Count;
   begin
      Begin_Pair;
      Before := Executive.Overruns;
      Wake (11);
      Expect_Late ("the first", (1 => First));
      Expect ("overruns", Executive.Overruns, Before + 1);

      --  The second is late because the first took too long.
      Run (First, At_Tick => 11, Ticks => 4);
      Expect_Late ("the second", (1 => Second));
      Run (Second, At_Tick => 15);
      Expect_Idle ("both have run");
      Expect ("overruns", Executive.Overruns, Before + 2);

      --  In the next frame both are on time.
      Wake (20);
      Run (First, At_Tick => 20);
      Wake (24);
      Run (Second, At_Tick => 24);
      Expect_Late ("in time again", Nobody);
   end Late_Release;

   procedure Long_Step is
      Before : Count;
   begin
      --  One tick less than a frame is not too long for the first task. The
      --  second is late.
      Begin_Pair;
      Before := Executive.Overruns;
      Wake (10);
      Run (First, At_Tick => 10, Ticks => 9);
      Expect_Late ("a tick less", (1 => Second));
      Run (Second, At_Tick => 19);
      Wake (20);
      Run (First, At_Tick => 20);
      Wake (24);
      Run (Second, At_Tick => 24);
      Expect_Late ("in time again", Nobody);
      Wake (30);
      Run (First, At_Tick => 30, Ticks => 10);
      Expect_Late ("ran into its next release", (First, Second));
      Expect ("overruns", Executive.Overruns, Before + 3);

      --  This release is lost; the next one is in the next frame.
      Run (Second, At_Tick => 40);
      Expect_Idle ("both have run");
      Wake (50);
      Run (First, At_Tick => 50);
      Wake (54);
      Run (Second, At_Tick => 54);
      Expect_Late ("in time in the end", Nobody);
   end Long_Step;

   procedure Late_By_An_Exit is
      Before : Count;
   begin
      --  The polite task's step lasts until the first task has been due for
      --  two ticks. Its EXIT then lets the first run.
      Begin_Pair;
      Executive.Start
        (((Polite, 0, 1), (First, 10, 9), others => Null_Header), 0);
      Before := Executive.Overruns;
      Run (Polite, At_Tick => 0, Ticks => 12);
      Run (First, At_Tick => 12);
      Expect ("overruns", Executive.Overruns, Before + 1);
      Expect_Late ("released late", (1 => First));
   end Late_By_An_Exit;

   procedure Exits_In_Time is
      Runs_On : Boolean;
   begin
      Begin_Pair;
      Executive.Start
        (((Polite, 0, 1), (First, 10, 9), others => Null_Header), 0);

      --  Without a due task of higher priority it continues, whatever the
      --  time.
      for Now in Clock_Tick range 0 .. 9 loop
         Takes := (if Now < 9 then 1 else 0);
         Executive.Run_Step (Runs_On);
         Expect ("who runs", Ran, Polite);
         Expect ("when", Began, Now);
         Expect ("runs on", Runs_On, True);
      end loop;
      Takes := 1;
      Executive.Run_Step (Runs_On);
      Expect ("runs on when the first is due", Runs_On, False);
      Run (First, At_Tick => 10);
      Run (Polite, At_Tick => 10);
      Expect_Late ("all in time", Nobody);
   end Exits_In_Time;

   procedure Next_Releases is
      Released : Tick;
   begin
      --  Whenever a step ends, its task sleeps until its offset in the major
      --  frame after that.
      for Offset in Minor_Frame loop
         for Ends in Clock_Tick range 100 .. 119 loop
            Begin_Pair;
            Executive.Start (Alone (100), 100);
            Time := 100;
            First_Call := (Next_Frame_Call, Offset => Offset, others => <>);
            Run (First, At_Tick => 100, Ticks => Ends - 100);
            Released := Ends - Ends mod 10 + 10 + Tick (Offset);
            Wake (Released - 1);
            Expect_Idle ("a tick before its release");
            Wake (Released);
            Run (First, At_Tick => Released);
            Expect_Late
              ("after" & Ends'Image,
               (if Ends >= 110 then (1 => First) else Nobody));
         end loop;
      end loop;
   end Next_Releases;

   procedure Sleeps is
   begin
      --  SLEEP until a tick that has passed when the step ends is SLEEP until
      --  the next tick. A later tick is kept.
      for Ends in Clock_Tick range 100 .. 109 loop
         Begin_Pair;
         Executive.Start (Alone (100), 100);
         Time := 100;
         First_Call := (Sleep_Call, Until_Tick => 105, others => <>);
         Run (First, At_Tick => 100, Ticks => Ends - 100);
         Wake (Tick'Max (105, Ends + 1) - 1);
         Expect_Idle ("a tick before");
         Wake (Tick'Max (105, Ends + 1));
         Run (First, At_Tick => Tick'Max (105, Ends + 1));
         Expect_Late ("until 105", Nobody);
      end loop;
   end Sleeps;

   procedure Any_Minor_Frame is
      Due : Clock_Tick := 0;
   begin
      --  The first task is released 7 ticks after each release, in another
      --  minor frame each time. The second keeps to minor frame 4.
      First_Call := (Sleep_Call, Until_Tick => 7, others => <>);
      Time := 0;
      Executive.Start (Pair (0), 0);
      Run (First, At_Tick => 0);
      Run (Second, At_Tick => 0);
      for Now in Clock_Tick range 1 .. 100 loop
         Wake (Now);
         if Now = Due + 7 then
            Due := Now;
            First_Call.Until_Tick := Due + 7;
            Run (First, At_Tick => Now);
         end if;
         if Now > 10 and then Now mod 10 = 4 then
            Run (Second, At_Tick => Now);
         end if;
         Expect_Idle ("between two releases");
      end loop;

      --  Two tasks that are loaded before they start.
      Executive.Start
        (((First, 123, 9), (Second, 125, 8), others => Null_Header), 100);
      First_Call.Until_Tick := 200;
      for Now in Clock_Tick range 101 .. 125 loop
         Wake (Now);
         if Now = 123 then
            Run (First, At_Tick => 123);
         elsif Now = 125 then
            Run (Second, At_Tick => 125);
         end if;
         Expect_Idle ("before and after a start time");
      end loop;
   end Any_Minor_Frame;

   procedure Counts_Stay is
      Before : Count;
   begin
      Begin_Pair;
      Before := Executive.Overruns;
      Wake (11);
      Executive.Start (Pair (20), 20);
      Expect ("overruns", Executive.Overruns, Before + 1);
      Time := 20;
      Run (First, At_Tick => 20);
      Run (Second, At_Tick => 20);
      Wake (31);
      Expect ("overruns", Executive.Overruns, Before + 2);
      Executive.Start (Empty_Tree, 40);
      Expect ("overruns", Executive.Overruns, Before + 2);
   end Counts_Stay;

   procedure Clock_Runs_Back is
   begin
      Begin_Pair;
      Wake (10);
      Run (First, At_Tick => 10);
      Wake (3);
      Expect_Idle ("back at tick 3");
      Wake (10);
      Expect_Idle ("at tick 10 again");
      Wake (14);

      --  The same when it is read after a step.
      Time := 5;
      Run (Second, At_Tick => 14);
      Expect_Idle ("both have run");
      Wake (19);
      Expect_Idle ("before the frame");
      Wake (20);
      Run (First, At_Tick => 20);
      Wake (24);
      Run (Second, At_Tick => 24);
      Expect_Late ("all in time", Nobody);
   end Clock_Runs_Back;

   procedure Idle is
   begin
      Begin_Pair;
      Executive.Start (Empty_Tree, 0);
      Expect_Idle ("without tasks");
      Wake (10);
      Expect_Idle ("without tasks, at a frame");
      Executive.Run_Until_Idle;
      Expect ("who runs", Ran, No_Task);

      --  A start also replaces tasks that are due.
      Executive.Start (Pair (10), 10);
      Executive.Start (Empty_Tree, 10);
      Expect_Idle ("after a start without tasks");
   end Idle;

   procedure Last_Ticks is
   begin
      Begin_Pair;
      Executive.Start (Pair (Last_Tick - 9), Last_Tick - 9);
      Time := Last_Tick - 9;
      Run (First, At_Tick => Last_Tick - 9, Ticks => 9);
      Run (Second, At_Tick => Last_Tick);
      Wake (Last_Tick);
      Expect_Idle ("at the last tick");
   end Last_Ticks;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "KRN-3 FRM-3 one task at a time is resumed, at its offset",
         Turns'Access);
      Add
        (Suite, "KRN-1 a task's first step after a start is known as such",
         First_Steps'Access);
      Add
        (Suite, "FRM-4 a task that is resumed late is reported, counted",
         Late_Release'Access);
      Add
        (Suite, "FRM-4 a task that runs into its next release is, too",
         Long_Step'Access);
      Add
        (Suite, "FRM-4 KRN-2 a task that an EXIT resumes late is, too",
         Late_By_An_Exit'Access);
      Add
        (Suite, "KRN-2 D-25 a task that calls EXIT runs on until a higher one "
         & "is due", Exits_In_Time'Access);
      Add
        (Suite, "FRM-3 the next release counts from the end of a step",
         Next_Releases'Access);
      Add
        (Suite, "KRN-3 SLEEP until a tick that has passed is until the next",
         Sleeps'Access);
      Add
        (Suite, "KRN-3 a task is released at its tick in any minor frame",
         Any_Minor_Frame'Access);
      Add
        (Suite, "FRM-4 overruns are counted across starts",
         Counts_Stay'Access);
      Add
        (Suite, "FRM-1 a clock that runs back is not believed",
         Clock_Runs_Back'Access);
      Add
        (Suite, "KRN-1 without tasks no task is resumed",
         Idle'Access);
      Add
        (Suite, "FRM-3 a step that lasts until the last tick is the last",
         Last_Ticks'Access);
   end Add_To;

end Clocked_Executives_Tests;
