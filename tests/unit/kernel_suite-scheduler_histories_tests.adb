--  SPDX-License-Identifier: Apache-2.0

with Ada.Strings.Fixed;
with Ada.Strings.Unbounded;
with AUnit.Assertions;       use AUnit.Assertions;
with Checks;                 use Checks;
with GNAT.Source_Info;
with URVOS;                  use URVOS;
with URVOS.Frames;           use URVOS.Frames;
with URVOS.Schedulers;       use URVOS.Schedulers;
with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;
with URVOS.Task_Trees;       use URVOS.Task_Trees;

separate (Kernel_Suite)
package body Scheduler_Histories_Tests is

   --  The tests, in order.
   procedure A_Frame;
   procedure Turns_At_Exit;
   procedure Waking_Order;
   procedure Loading_And_Ending;

   S : Scheduler;

   --  Each procedure makes one call or moves the clock. Then an idle processor
   --  gets the next task. State and Late are the expected results. A state has
   --  four lists:
   --
   --     running task | ready tasks | sleeping tasks | next free TCB
   --
   --  Tasks are numbers. Ready tasks are in the order in which they will run.
   --  Sleeping tasks have their ticks, and are in the order of ticks, then of
   --  TCBs. Late is the number of overruns so far.

   procedure Starts
     (Tree  : Task_Tree;
      Now   : Clock_Tick;
      State : String;
      Late  : Count;
      Line  : Positive := GNAT.Source_Info.Line);

   procedure Loads
     (Header : Task_Header;
      State  : String;
      Late   : Count;
      Line   : Positive := GNAT.Source_Info.Line);

   procedure Ticks
     (Now   : Clock_Tick;
      State : String;
      Late  : Count;
      Line  : Positive := GNAT.Source_Info.Line);

   procedure Exits
     (State : String;
      Late  : Count;
      Line  : Positive := GNAT.Source_Info.Line);

   procedure Sleeps
     (Until_Tick : Tick;
      State      : String;
      Late       : Count;
      Line       : Positive := GNAT.Source_Info.Line);

   procedure Ends
     (State : String;
      Late  : Count;
      Line  : Positive := GNAT.Source_Info.Line);

   procedure Expect (State : String; Late : Count; Line : Positive);

   --  The list of a queue; for the free TCBs only the first.
   function List_Of (Queue : Queue_Name) return String;

   function List_Of (Queue : Queue_Name) return String is
      use Ada.Strings.Fixed;
      use Ada.Strings.Unbounded;

      function Is_Before (First, Other : TCB_Number) return Boolean is
        (if Queue = Timer
         then (if TCB (S, First).Release = TCB (S, Other).Release
               then First < Other
               else TCB (S, First).Release < TCB (S, Other).Release)
         else Is_Ahead (S, First, Other));

      function Name_Of (Which : TCB_Number) return String is
        (case Queue is
            when Running | Ready => TCB (S, Which).Id'Image,
            when Timer           =>
              TCB (S, Which).Id'Image & '@'
              & Trim (TCB (S, Which).Release'Image, Ada.Strings.Left),
            when Free            => Which'Image);

      Listed : array (TCB_Number) of Boolean := (others => False);
      List   : Unbounded_String;
      Next   : TCB_Count;
   begin
      loop
         Next := No_TCB;
         for Which in TCB_Number loop
            if Queue_Of (S, Which) = Queue
              and then not Listed (Which)
              and then (Next = No_TCB or else Is_Before (Which, Next))
            then
               Next := Which;
            end if;
         end loop;
         exit when Next = No_TCB;
         Listed (Next) := True;
         Append (List, Name_Of (Next));
         exit when Queue = Free;
      end loop;
      return (if List = "" then " -" else To_String (List));
   end List_Of;

   procedure Expect (State : String; Late : Count; Line : Positive) is
      Found : constant String :=
        List_Of (Running) & " |" & List_Of (Ready) & " |" & List_Of (Timer)
        & " |" & List_Of (Free);
   begin
      Assert
        (Found = ' ' & State,
         "state is" & Found & ", expected " & State,
         GNAT.Source_Info.File, Line);
      Assert
        (Overruns (S) = Late,
         "overruns are" & Overruns (S)'Image & ", expected" & Late'Image,
         GNAT.Source_Info.File, Line);
   end Expect;

   procedure Starts
     (Tree  : Task_Tree;
      Now   : Clock_Tick;
      State : String;
      Late  : Count;
      Line  : Positive := GNAT.Source_Info.Line) is
   begin
      Start (S, Tree, Now);
      Expect (State, Late, Line);
   end Starts;

   procedure Loads
     (Header : Task_Header;
      State  : String;
      Late   : Count;
      Line   : Positive := GNAT.Source_Info.Line) is
   begin
      Load (S, Header);
      Dispatch (S);
      Expect (State, Late, Line);
   end Loads;

   procedure Ticks
     (Now   : Clock_Tick;
      State : String;
      Late  : Count;
      Line  : Positive := GNAT.Source_Info.Line) is
   begin
      Wake (S, Now);
      Dispatch (S);
      Expect (State, Late, Line);
   end Ticks;

   procedure Exits
     (State : String;
      Late  : Count;
      Line  : Positive := GNAT.Source_Info.Line) is
   begin
      Exit_Call (S);
      Expect (State, Late, Line);
   end Exits;

   procedure Sleeps
     (Until_Tick : Tick;
      State      : String;
      Late       : Count;
      Line       : Positive := GNAT.Source_Info.Line) is
   begin
      Sleep (S, Until_Tick);
      Dispatch (S);
      Expect (State, Late, Line);
   end Sleeps;

   procedure Ends
     (State : String;
      Late  : Count;
      Line  : Positive := GNAT.Source_Info.Line) is
   begin
      Terminate_Caller (S);
      Dispatch (S);
      Expect (State, Late, Line);
   end Ends;

   --  Headers are: number, start time, priority.

   procedure A_Frame is
   begin
      Starts
        ((1 => (1, 10, 3), 2 => (2, 10, 2), 3 => (3, 14, 1),
          others => Null_Header),
         Now => 10,   State => "1 | 2 | 3@14 | 4", Late => 0);
      Sleeps (20,              "2 | - | 3@14 1@20 | 4",    0);
      Ticks  (12,              "2 | - | 3@14 1@20 | 4",    0);
      Sleeps (22,              "- | - | 3@14 1@20 2@22 | 4", 0);
      Ticks  (13,              "- | - | 3@14 1@20 2@22 | 4", 0);
      Ticks  (14,              "3 | - | 1@20 2@22 | 4",    0);

      --  No preemption: a task of higher priority waits until the running one
      --  calls.
      Ticks  (20,              "3 | 1 | 2@22 | 4",         0);
      Sleeps (24,              "1 | - | 2@22 3@24 | 4",    0);
      Ticks  (22,              "1 | 2 | 3@24 | 4",         0);
      Ticks  (24,              "1 | 2 3 | - | 4",          0);
      Exits                   ("1 | 2 3 | - | 4",          0);

      --  Task 2 was due at 22 and runs at 24: late.
      Sleeps (30,              "2 | 3 | 1@30 | 4",         1);
      Sleeps (32,              "3 | - | 1@30 2@32 | 4",    1);
      Ends                    ("- | - | 1@30 2@32 | 4",    1);
      Ticks  (29,              "- | - | 1@30 2@32 | 4",    1);
      Ticks  (30,              "1 | - | 2@32 | 4",         1);
      Ticks  (40,              "1 | 2 | - | 4",            1);

      --  Task 1 has run from 30 into its next release; task 2 is late.
      Sleeps (40,              "2 | - | 1@41 | 4",         3);
      Ticks  (41,              "2 | 1 | - | 4",            3);
   end A_Frame;

   procedure Turns_At_Exit is
   begin
      Starts
        ((1 => (1, 0, 2), 2 => (2, 0, 2), 3 => (3, 2, 3), 4 => (4, 1, 2),
          5 => (5, 0, 1), others => Null_Header),
         Now => 0,    State => "1 | 2 5 | 4@1 3@2 | 6", Late => 0);
      Ticks  (1,               "1 | 2 4 5 | 3@2 | 6",      0);
      Exits                   ("1 | 2 4 5 | 3@2 | 6",      0);
      Ticks  (2,               "1 | 3 2 4 5 | - | 6",      0);

      --  The caller follows its equals, and precedes the lower task.
      Exits                   ("3 | 2 4 1 5 | - | 6",      0);
      Sleeps (3,               "2 | 4 1 5 | 3@3 | 6",      1);
      Ticks  (3,               "2 | 3 4 1 5 | - | 6",      1);
      Exits                   ("3 | 4 1 2 5 | - | 6",      1);
      Exits                   ("3 | 4 1 2 5 | - | 6",      1);
      Ends                    ("4 | 1 2 5 | - | 6",        2);
      Exits                   ("4 | 1 2 5 | - | 6",        2);

      --  Tick 0 has passed: the sleep lasts one tick. Task 1 has run before.
      Sleeps (0,               "1 | 2 5 | 4@4 | 6",        2);
      Sleeps (4,               "2 | 5 | 1@4 4@4 | 6",      2);

      --  Task 4 came first to the timer queue.
      Ticks  (4,               "2 | 4 1 5 | - | 6",        2);
      Sleeps (9,               "4 | 1 5 | 2@9 | 6",        2);
      Ends                    ("1 | 5 | 2@9 | 6",          2);
      Ends                    ("5 | - | 2@9 | 6",          3);
      Ends                    ("- | - | 2@9 | 6",          3);
      Ticks  (8,               "- | - | 2@9 | 6",          3);
      Ticks  (9,               "2 | - | - | 6",            3);
      Ends                    ("- | - | - | 6",            3);
   end Turns_At_Exit;

   procedure Waking_Order is
   begin
      Starts
        ((1 => (1, 0, 4), 2 => (2, 5, 4), 3 => (3, 3, 4), 4 => (4, 6, 9),
          5 => (5, 0, 4), 6 => (6, 0, 5), others => Null_Header),
         Now => 0,    State => "6 | 1 5 | 3@3 2@5 4@6 | 7", Late => 0);

      --  They follow the ready tasks of their priority, in the order of ticks,
      --  although the clock was not read for a while.
      Ticks  (7,               "6 | 4 1 5 3 2 | - | 7",    0);
      Sleeps (17,              "4 | 1 5 3 2 | 6@17 | 7",   1);
      Sleeps (16,              "1 | 5 3 2 | 4@16 6@17 | 7", 2);
      Exits                   ("1 | 5 3 2 | 4@16 6@17 | 7", 2);
      Ticks  (17,              "1 | 4 6 5 3 2 | - | 7",    2);
      Exits                   ("4 | 6 5 3 2 1 | - | 7",    3);
      Sleeps (26,              "6 | 5 3 2 1 | 4@26 | 7",   3);
      Sleeps (27,              "5 | 3 2 1 | 4@26 6@27 | 7", 4);
      Ticks  (26,              "5 | 4 3 2 1 | 6@27 | 7",   4);

      --  Task 5 was released at 0, and still ran at 10.
      Sleeps (30,              "4 | 3 2 1 | 6@27 5@30 | 7", 5);
   end Waking_Order;

   procedure Loading_And_Ending is
   begin
      Starts
        ((1 => (9, 0, 1), 2 => (8, 7, 2), 3 => Null_Header, 4 => (7, 0, 9),
          others => Null_Header),
         Now => 5,    State => "9 | - | 8@7 | 3", Late => 1);

      --  A task that was due before it is loaded follows its equals.
      Loads  ((6, 5, 3),       "9 | 6 | 8@7 | 4",          1);
      Loads  ((2, 0, 3),       "9 | 6 2 | 8@7 | 5",        1);
      Loads  ((5, 9, 3),       "9 | 6 2 | 8@7 5@9 | 6",    1);

      --  A freed TCB is the last to be used again.
      Ends                    ("6 | 2 | 8@7 5@9 | 6",      1);
      Sleeps (30,              "2 | - | 8@7 5@9 6@30 | 6", 2);
      Ends                    ("- | - | 8@7 5@9 6@30 | 6", 2);
      for Next in TCB_Number range 6 .. 16 loop
         declare
            Free : constant String :=
              (if Next = 16 then " 1" else TCB_Count'Image (Next + 1));
         begin
            Loads ((4, 5, 0),  "4 | - | 8@7 5@9 6@30 |" & Free, 2);
            Ends              ("- | - | 8@7 5@9 6@30 |" & Free, 2);
         end;
      end loop;
      Loads  ((3, 5, 0),       "3 | - | 8@7 5@9 6@30 | 4", 2);
      Ticks  (9,               "3 | 5 8 | 6@30 | 4",       2);
      Ends                    ("5 | 8 | 6@30 | 4",         2);
      Ends                    ("8 | - | 6@30 | 4",         3);
   end Loading_And_Ending;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "KRN-1 KRN-2 KRN-3 KRN-4 FRM-4 a frame of three tasks",
         A_Frame'Access);
      Add
        (Suite, "KRN-2 KRN-3 equals take turns at EXIT and SLEEP",
         Turns_At_Exit'Access);
      Add
        (Suite, "KRN-3 FRM-4 sleeping tasks wake in the order of ticks",
         Waking_Order'Access);
      Add
        (Suite, "KRN-1 KRN-4 tasks are loaded into the TCBs that are free",
         Loading_And_Ending'Access);
   end Add_To;

end Scheduler_Histories_Tests;
