--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time;           use Ada.Real_Time;
with Ada.Task_Identification; use Ada.Task_Identification;
with Checks;                  use Checks;
with Expectations;            use Expectations;
with URVOS;                   use URVOS;
with URVOS.Frames;            use URVOS.Frames;
with URVOS.Kernel_Calls;      use URVOS.Kernel_Calls;
with URVOS.Node_Software;
with URVOS.Real_Time_Nodes;
with URVOS.Starts;            use URVOS.Starts;
with URVOS.Task_Lists;
with URVOS.Task_Trees;        use URVOS.Task_Trees;

separate (Node_Suite)
package body Real_Time_Nodes_Tests is

   --  The tests, in order.
   procedure One_Processor;
   procedure Two_Processors;
   procedure More_Processors;
   procedure Failed_Test;
   procedure Wish_In_A_Start;
   procedure Wish_In_A_Step;

   --  A task for each of four processors; with two processors, two for each.
   type Task_Name is (Input, Collection, Output, Recording);

   type Task_Table is array (Task_Name) of Task_Attributes;

   Table : constant Task_Table :=
     (Input      => (others => (Offset => 0, Processor => 1)),
      Collection => (others => (Offset => 1, Processor => 2)),
      Output     => (others => (Offset => 2, Processor => 3)),
      Recording  => (others => (Offset => 3, Processor => 4)));

   package Tasks is new URVOS.Task_Lists (Task_Name, Task_Table, Table);

   subtype Ada_Task is Ada.Task_Identification.Task_Id;

   type Natural_Counts is array (Task_Name) of Natural;
   type Runner_List is array (Task_Name) of Ada_Task;
   type Condition_List is array (1 .. 10) of Start_Condition;
   type Processor_List is array (Processor_Number) of Ada_Task;

   --  The node's activity, as its tasks report it. No test depends on the
   --  machine's speed.
   protected Witness is

      procedure Clear;

      --  A processor has appeared.
      procedure Meet (Processor : Ada_Task);

      procedure Begin_Step (Who : Task_Name; First_Run : Boolean);
      procedure End_Step;

      procedure Begin_Start (Condition : Start_Condition);
      procedure End_Start;

      procedure Count_Overrun;

      --  Plans a request for the next step of a transaction, or for the next
      --  phase 1.
      procedure Plan (In_Step, In_Start : Boolean);
      procedure Take_Step_Plan (Is_Wanted : out Boolean);
      procedure Take_Start_Plan (Is_Wanted : out Boolean);

      --  Sets the results of the next self-tests.
      procedure Set_Test (Passes : Boolean);
      function Test_Passes return Boolean;

      function Is_Sound return Boolean;
      function Starts return Natural;
      function Condition (Number : Positive) return Start_Condition;
      function Transactions return Natural_Counts;
      function Runners return Runner_List;
      function Processors return Natural;
      function Processor (Which : Processor_Number) return Ada_Task;
      function Overruns return Count;

   private
      Sound       : Boolean := True;
      In_Phases   : Boolean := False;
      Under_Way   : Natural := 0;
      Begun       : Natural := 0;
      Conditions  : Condition_List := (others => Cold_Start);
      Initialised : Natural_Counts := (others => 0);
      Done        : Natural_Counts := (others => 0);
      Ran_On      : Runner_List    := (others => Null_Task_Id);
      Met         : Natural := 0;
      Machine     : Processor_List := (others => Null_Task_Id);
      Late        : Count   := 0;
      Step_Plan   : Boolean := False;
      Start_Plan  : Boolean := False;
      Passes_Now  : Boolean := True;
   end Witness;

   --  The node's own side

   procedure Run_Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);

   procedure Set_Time (Now : Clock_Tick);

   procedure Report_Overrun (Unused_Who : URVOS.Task_Trees.Task_Id);

   procedure Observe_Tick (Late : Time_Span);

   --  The node under test, for the requests and the monitors

   type Request_Access is access procedure (Condition : Start_Condition);
   type Count_Access is access function return Count;
   type Clock_Access is access function return Clock_Tick;

   Request       : Request_Access := null;
   Node_Overruns : Count_Access   := null;
   Node_Clock    : Clock_Access   := null;

   --  A node that lives as long as a test. A node's processors never end, so
   --  the test aborts them, by the names that they report.
   generic
      with procedure Test;
   procedure With_Node (Processors : Processor_Number);

   --  Waits until the condition holds. The test fails after one minute.
   procedure Wait_For
     (What : String; Is_So : not null access function return Boolean);

   --  Waits until every task has run this number of further transactions.
   procedure Wait_For_Transactions (More : Positive);

   --  Waits until this number of starts was made, the last with this
   --  condition.
   procedure Wait_For_Start (Number : Positive; Condition : Start_Condition);

   protected body Witness is

      procedure Clear is
      begin
         Sound := True;
         In_Phases := False;
         Under_Way := 0;
         Begun := 0;
         Initialised := (others => 0);
         Done := (others => 0);
         Ran_On := (others => Null_Task_Id);
         Met := 0;
         Late := 0;
         Step_Plan := False;
         Start_Plan := False;
         Passes_Now := True;
      end Clear;

      procedure Meet (Processor : Ada_Task) is
      begin
         for Which in 1 .. Met loop
            if Machine (Processor_Number (Which)) = Processor then
               return;
            end if;
         end loop;
         Met := Met + 1;
         Machine (Processor_Number (Met)) := Processor;
      end Meet;

      --  A task's first step after a start initialises; no other step does.
      procedure Begin_Step (Who : Task_Name; First_Run : Boolean) is
      begin
         Under_Way := Under_Way + 1;
         if In_Phases or else First_Run /= (Initialised (Who) < Begun) then
            Sound := False;
         end if;
         if First_Run then
            Initialised (Who) := Begun;
         else
            Done (Who) := Done (Who) + 1;
         end if;
         Ran_On (Who) := Current_Task;
      end Begin_Step;

      procedure End_Step is
      begin
         Under_Way := Under_Way - 1;
      end End_Step;

      procedure Begin_Start (Condition : Start_Condition) is
      begin
         if In_Phases or else Under_Way > 0 then
            Sound := False;
         end if;
         In_Phases := True;
         Begun := Begun + 1;
         Conditions (Begun) := Condition;
      end Begin_Start;

      procedure End_Start is
      begin
         In_Phases := False;
      end End_Start;

      procedure Count_Overrun is
      begin
         Late := Incremented (Late);
      end Count_Overrun;

      procedure Plan (In_Step, In_Start : Boolean) is
      begin
         Step_Plan := In_Step;
         Start_Plan := In_Start;
      end Plan;

      procedure Take_Step_Plan (Is_Wanted : out Boolean) is
      begin
         Is_Wanted := Step_Plan;
         Step_Plan := False;
      end Take_Step_Plan;

      procedure Take_Start_Plan (Is_Wanted : out Boolean) is
      begin
         Is_Wanted := Start_Plan;
         Start_Plan := False;
      end Take_Start_Plan;

      procedure Set_Test (Passes : Boolean) is
      begin
         Passes_Now := Passes;
      end Set_Test;

      function Test_Passes return Boolean is (Passes_Now);
      function Is_Sound return Boolean is (Sound);
      function Starts return Natural is (Begun);
      function Condition (Number : Positive) return Start_Condition is
        (Conditions (Number));
      function Transactions return Natural_Counts is (Done);
      function Runners return Runner_List is (Ran_On);
      function Processors return Natural is (Met);
      function Processor (Which : Processor_Number) return Ada_Task is
        (Machine (Which));
      function Overruns return Count is (Late);

   end Witness;

   procedure Run_Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call)
   is
      pragma Unreferenced (Now);
      Wishes : Boolean := False;
   begin
      Witness.Begin_Step (Who, First_Run);
      if not First_Run then
         Witness.Take_Step_Plan (Wishes);
      end if;
      if Wishes then
         Request.all (Processor_Restart);
      end if;

      --  Long enough for the other processor to intervene.
      delay 0.000_5;
      Witness.End_Step;
      Call :=
        (Next_Frame_Call, Offset => Table (Who) (Report).Offset, others => <>);
   end Run_Step;

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean)
   is
      pragma Unreferenced (Now);
      Wishes : Boolean;
   begin
      Witness.Begin_Start (Condition);

      --  Wait some ticks.
      delay 0.01;
      Witness.Take_Start_Plan (Wishes);
      if Wishes then
         Request.all (Warm_Reset);
      end if;
      Passed := Witness.Test_Passes;
      Witness.End_Start;
   end Begin_Again;

   procedure Set_Time (Now : Clock_Tick) is
      pragma Unreferenced (Now);
   begin
      Witness.Meet (Current_Task);
   end Set_Time;

   procedure Report_Overrun (Unused_Who : URVOS.Task_Trees.Task_Id) is
   begin
      Witness.Count_Overrun;
   end Report_Overrun;

   procedure Observe_Tick (Late : Time_Span) is null;

   procedure Wait_For
     (What : String; Is_So : not null access function return Boolean) is
   begin
      for Time in 1 .. 60_000 loop
         exit when Is_So.all;
         delay 0.001;
      end loop;
      Expect (What, Is_So.all, True);
   end Wait_For;

   procedure Wait_For_Transactions (More : Positive) is
      Before : constant Natural_Counts := Witness.Transactions;

      function Have_Run return Boolean;

      function Have_Run return Boolean is
         Now : constant Natural_Counts := Witness.Transactions;
      begin
         return
           (for all Who in Task_Name => Now (Who) >= Before (Who) + More);
      end Have_Run;
   begin
      Wait_For ("every task runs", Have_Run'Access);
   end Wait_For_Transactions;

   procedure Wait_For_Start (Number : Positive; Condition : Start_Condition)
   is
      function Has_Begun return Boolean is (Witness.Starts >= Number);
   begin
      Wait_For ("a start", Has_Begun'Access);
      Expect
        ("condition of start" & Number'Image,
         Witness.Condition (Number) = Condition, True);
   end Wait_For_Start;

   procedure With_Node (Processors : Processor_Number) is

      package Software is new URVOS.Node_Software
        (Tasks, Run_Step, Begin_Again, Set_Time, Report_Overrun);

      package This_Node is
        new URVOS.Real_Time_Nodes (Software, Observe_Tick);

      procedure Request_Start (Condition : Start_Condition);
      function Overruns return Count;
      function Present return Clock_Tick;

      procedure End_Processors;

      function Overruns return Count is
      begin
         return Number : Count do
            This_Node.Inspect_Overruns (Number);
         end return;
      end Overruns;

      function Present return Clock_Tick is
      begin
         return Now : Clock_Tick do
            This_Node.Inspect_Clock (Now);
         end return;
      end Present;

      procedure Request_Start (Condition : Start_Condition) is
      begin
         This_Node.Request_Start (Condition);
      end Request_Start;

      procedure End_Processors is
         Last : constant Processor_Number := Processor_Number'Last;

         function Are_There return Boolean is
           (Witness.Processors = Natural (Last));
      begin
         --  A processor that was not switched on reports its name only then.
         if Processors < Last then
            This_Node.Switch_On (Last, Clock);
         end if;
         Wait_For ("all processors", Are_There'Access);
         for Which in Processor_Number loop
            Abort_Task (Witness.Processor (Which));
         end loop;
      end End_Processors;

   begin
      Witness.Clear;
      Request := Request_Start'Unrestricted_Access;
      Node_Overruns := Overruns'Unrestricted_Access;
      Node_Clock := Present'Unrestricted_Access;
      This_Node.Switch_On (Processors, Clock);
      begin
         Test;
         Expect
           ("phases 1 and 2 alone, first steps and no others initialise",
            Witness.Is_Sound, True);
      exception
         when others =>
            End_Processors;
            raise;
      end;
      End_Processors;
   end With_Node;

   procedure One_Processor is
      procedure Fly;

      procedure Fly is
         Runners : Runner_List;
      begin
         Wait_For_Start (1, Cold_Start);
         Wait_For_Transactions (3);
         Runners := Witness.Runners;
         for Who in Task_Name loop
            Expect
              (Who'Image & " on the one processor",
               Runners (Who) = Runners (Input), True);
         end loop;
         Expect_Number ("processors", Witness.Processors, 1);
         for Condition in Start_Condition loop
            Request.all (Condition);
            Wait_For_Start
              (2 + Start_Condition'Pos (Condition), Condition);
            Wait_For_Transactions (2);
         end loop;
         Expect_Number ("starts", Witness.Starts, 4);
      end Fly;

      procedure Run is new With_Node (Fly);
   begin
      Run (Processors => 1);
   end One_Processor;

   procedure Two_Processors is
      procedure Fly;

      procedure Fly is
         Runners : Runner_List;
      begin
         Wait_For_Start (1, Cold_Start);
         Wait_For_Transactions (3);
         Runners := Witness.Runners;
         Expect
           ("on the first processor", Runners (Output) = Runners (Input),
            True);
         Expect
           ("on the second",
            Runners (Recording) = Runners (Collection), True);
         Expect
           ("these are two", Runners (Collection) = Runners (Input), False);
         for Condition in Start_Condition loop
            Request.all (Condition);
            Wait_For_Start
              (2 + Start_Condition'Pos (Condition), Condition);
            Wait_For_Transactions (2);
         end loop;
         Expect_Number ("starts", Witness.Starts, 4);
      end Fly;

      procedure Run is new With_Node (Fly);
   begin
      Run (Processors => 2);
   end Two_Processors;

   --  Each task runs on the processor of its row, counted round if there are
   --  three.
   procedure More_Processors is

      generic
         Number : Processor_Number;
      procedure Fly;

      procedure Fly is
         Runners : Runner_List;
      begin
         Wait_For_Start (1, Cold_Start);
         Wait_For_Transactions (3);
         Runners := Witness.Runners;
         Expect_Number ("processors", Witness.Processors, Integer (Number));
         for Who in Task_Name loop
            for Other in Task_Name loop
               Expect
                 (Who'Image & " and " & Other'Image & " on one of"
                  & Number'Image,
                  Runners (Who) = Runners (Other),
                  Task_Name'Pos (Who) mod Positive (Number) =
                    Task_Name'Pos (Other) mod Positive (Number));
            end loop;
         end loop;
         for Condition in Start_Condition loop
            Request.all (Condition);
            Wait_For_Start
              (2 + Start_Condition'Pos (Condition), Condition);
            Wait_For_Transactions (2);
            Expect ("the same processors", Witness.Runners = Runners, True);
         end loop;
         Expect_Number ("starts", Witness.Starts, 4);
      end Fly;

      procedure Fly_3 is new Fly (3);
      procedure Fly_4 is new Fly (4);
      procedure Run_3 is new With_Node (Fly_3);
      procedure Run_4 is new With_Node (Fly_4);
   begin
      Run_3 (Processors => 3);
      Run_4 (Processors => 4);
   end More_Processors;

   procedure Failed_Test is
      procedure Fly;

      procedure Fly is
         Before    : Natural_Counts;
         Last_Tick : Clock_Tick;

         function Is_Later return Boolean is (Node_Clock.all > Last_Tick);

         function Is_Counted return Boolean is
           (Node_Overruns.all = Witness.Overruns);
      begin
         Wait_For_Transactions (1);
         Witness.Set_Test (Passes => False);
         Request.all (Warm_Reset);
         Wait_For_Start (2, Warm_Reset);

         --  From here on no task runs.
         Before := Witness.Transactions;
         Last_Tick := Node_Clock.all + 30;
         Wait_For ("three frames", Is_Later'Access);
         Expect ("nobody has run", Witness.Transactions = Before, True);
         Wait_For ("each overrun is counted", Is_Counted'Access);

         Witness.Set_Test (Passes => True);
         Request.all (Processor_Restart);
         Wait_For_Start (3, Processor_Restart);
         Wait_For_Transactions (2);
      end Fly;

      procedure Run is new With_Node (Fly);
   begin
      for Processors in Processor_Number loop
         Run (Processors);
      end loop;
   end Failed_Test;

   procedure Wish_In_A_Start is
      procedure Fly;

      procedure Fly is
      begin
         Wait_For_Transactions (1);
         Witness.Plan (In_Step => False, In_Start => True);
         Request.all (Processor_Restart);
         Wait_For_Start (2, Processor_Restart);
         Wait_For_Start (3, Warm_Reset);
         Wait_For_Transactions (2);
         Expect_Number ("starts", Witness.Starts, 3);
      end Fly;

      procedure Run is new With_Node (Fly);
   begin
      for Processors in Processor_Number loop
         Run (Processors);
      end loop;
   end Wish_In_A_Start;

   procedure Wish_In_A_Step is
      procedure Fly;

      procedure Fly is
      begin
         for Number in 2 .. 6 loop
            Wait_For_Transactions (1);
            Witness.Plan (In_Step => True, In_Start => False);
            Wait_For_Start (Number, Processor_Restart);
         end loop;
         Wait_For_Transactions (2);
         Expect_Number ("starts", Witness.Starts, 6);
      end Fly;

      procedure Run is new With_Node (Fly);
   begin
      for Processors in Processor_Number loop
         Run (Processors);
      end loop;
   end Wish_In_A_Step;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "KRN-1 KRN-3 INI-1 a real-time node starts and runs its tasks",
         One_Processor'Access);
      Add
        (Suite, "EXT-4 KRN-5 two processors run their tasks, none in a start",
         Two_Processors'Access);
      Add
        (Suite, "EXT-4 KRN-5 D-46 three and four processors by the list alone",
         More_Processors'Access);
      Add
        (Suite, "INI-2 FRM-4 after a failed test no task runs until a start",
         Failed_Test'Access);
      Add
        (Suite, "INI-1 EXT-4 a node that starts hears the next wish",
         Wish_In_A_Start'Access);
      Add
        (Suite, "KRN-6 EXT-4 a step that fails restarts the node, again and "
         & "again", Wish_In_A_Step'Access);
   end Add_To;

end Real_Time_Nodes_Tests;
