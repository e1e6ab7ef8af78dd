--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time;      use Ada.Real_Time;
with Checks;             use Checks;
with Expect_Value;
with Expectations;       use Expectations;
with URVOS;              use URVOS;
with URVOS.Executives;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Shared_Nodes; use URVOS.Shared_Nodes;
with URVOS.Start_Orders; use URVOS.Start_Orders;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

separate (Node_Suite)
package body Shared_Nodes_Tests is

   --  The tests, in order.
   procedure Request_While_Idle;
   procedure Request_During_Step;
   procedure Failed_Step;
   procedure Other_Processor;
   procedure Sums;
   procedure Absent_Processor;

   procedure Expect is new Expect_Value (Order_Name);
   procedure Expect is new Expect_Value (Start_Condition);
   procedure Expect is new Expect_Value (Task_Id);

   First  : constant Task_Id := 3;
   Second : constant Task_Id := 7;

   --  For either processor: its tasks sleep until minor frames 0 and 4.
   function Pair (Now : Clock_Tick) return Task_Tree is
     ((First, Now, 9), (Second, Now, 8), others => Null_Header);

   This_Node : Node;

   --  The task that requests a start during its next step, and the condition.
   Wisher : Task_Id         := No_Task;
   Wish   : Start_Condition := Cold_Start;

   --  The tasks that ran since the last look, in order.
   History : array (1 .. 20) of Task_Id;
   Ran     : Natural := 0;

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   procedure Report_Overrun (Who : Task_Id) is null;

   package Processor_1 is new URVOS.Executives (Step, Report_Overrun);
   package Processor_2 is new URVOS.Executives (Step, Report_Overrun);

   --  One tick of a processor of the node: it gets its order and carries it
   --  out.
   generic
      Who : Seat;
      with package Executive is new URVOS.Executives (<>);
   procedure Processor_Tick (Now : Clock_Tick; Expected : Order_Name);

   --  The master's test has ended.
   procedure End_Test (Condition : Start_Condition);

   --  The condition of the start that the master began.
   Begun : Start_Condition := Cold_Start;

   procedure Expect_Ran (What : String; Expected : Natural);

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call)
   is
      pragma Unreferenced (First_Run, Now);
   begin
      Ran := Ran + 1;
      History (Ran) := Who;
      if Who = Wisher then
         This_Node.Request (Wish);
         Wisher := No_Task;
      end if;
      Call :=
        (Next_Frame_Call, Offset => (if Who = First then 0 else 4),
         others => <>);
   end Step;

   procedure Processor_Tick (Now : Clock_Tick; Expected : Order_Name) is
      Next_Order     : Order;
      Unused_Runs_On : Boolean;
   begin
      This_Node.Look (Who, Next_Order);
      Expect
        ("processor" & Who'Image & " at tick" & Now'Image, Next_Order.Name,
         Expected);
      case Next_Order.Name is
         when Carry_On =>
            Executive.Clock_Interrupt (Now);
         when Load_Tasks =>
            Executive.Start
              ((if Next_Order.Passed then Pair (Now) else Empty_Tree), Now);
         when Begin_Start =>
            Begun := Next_Order.Condition;
         when Stand_Still =>
            null;
      end case;
      if Next_Order.Name in Carry_On | Load_Tasks then
         loop
            exit when This_Node.Is_Start_Wanted or else Executive.Is_Idle;
            Executive.Run_Step (Unused_Runs_On);
         end loop;
      end if;
      This_Node.Note_Tick (Who, Now, Executive.Overruns);
   end Processor_Tick;

   procedure Tick_1 is new Processor_Tick (1, Processor_1);
   procedure Tick_2 is new Processor_Tick (2, Processor_2);

   procedure End_Test (Condition : Start_Condition) is
   begin
      Expect ("condition", Begun, Condition);
      This_Node.Note_Tested
        (Passed  => True,
         Numbers => Numbers_For ((1 .. 2 => True, others => False)));
   end End_Test;

   procedure Expect_Ran (What : String; Expected : Natural) is
   begin
      Expect_Number (What & ", steps", Ran, Expected);
      Ran := 0;
   end Expect_Ran;

   --  One processor, whose tasks were loaded at a tick and have initialised.
   procedure Begin_One (Now : Clock_Tick);

   procedure Begin_One (Now : Clock_Tick) is
   begin
      Ran := 0;
      Wisher := No_Task;
      This_Node.Switch_On (1, Time_First);
      Tick_1 (Now, Begin_Start);
      End_Test (Cold_Start);
      Tick_1 (Now, Load_Tasks);
      Expect_Ran ("initialised", 2);
   end Begin_One;

   procedure Request_While_Idle is
   begin
      Begin_One (0);
      for Now in Clock_Tick range 1 .. 9 loop
         Tick_1 (Now, Carry_On);
      end loop;
      Expect_Ran ("before the frame", 0);

      --  The last of several requests counts, and no due task is resumed.
      Expect ("wanted", This_Node.Is_Start_Wanted, False);
      This_Node.Request (Processor_Restart);
      This_Node.Request (Warm_Reset);
      Expect ("wanted", This_Node.Is_Start_Wanted, True);
      Tick_1 (10, Begin_Start);
      Expect_Ran ("at the start", 0);
      Expect ("still wanted", This_Node.Is_Start_Wanted, False);
      End_Test (Warm_Reset);
      Tick_1 (11, Load_Tasks);
      Expect_Ran ("initialised again", 2);

      --  Only once.
      Tick_1 (12, Carry_On);
      Tick_1 (20, Carry_On);
      Expect_Ran ("at the frame", 1);
   end Request_While_Idle;

   procedure Request_During_Step is
   begin
      --  The step ends first. The second task, which is due as well, does not
      --  begin its own.
      Begin_One (0);
      Tick_1 (10, Carry_On);
      Expect_Ran ("the first", 1);
      Wisher := First;
      Wish := Warm_Reset;
      Tick_1 (24, Carry_On);
      Expect_Ran ("the first alone", 1);
      Expect ("who", History (1), First);
      Tick_1 (25, Begin_Start);
      Expect_Ran ("none at the start", 0);
      End_Test (Warm_Reset);
      Tick_1 (26, Load_Tasks);
      Expect_Ran ("both initialise", 2);
      Expect ("who", History (1), First);
      Tick_1 (30, Carry_On);
      Tick_1 (34, Carry_On);
      Expect_Ran ("each in its place", 2);
   end Request_During_Step;

   procedure Failed_Step is
   begin
      --  The code that catches a step's exception requests a restart, also
      --  from an initialisation.
      Ran := 0;
      This_Node.Switch_On (1, Time_First);
      Tick_1 (0, Begin_Start);
      End_Test (Cold_Start);
      Wisher := First;
      Wish := Processor_Restart;
      Tick_1 (0, Load_Tasks);
      Expect_Ran ("the failed one alone", 1);
      Tick_1 (1, Begin_Start);
      End_Test (Processor_Restart);
      Tick_1 (2, Load_Tasks);
      Expect_Ran ("both initialise", 2);

      --  The same from a transaction.
      Wisher := Second;
      Tick_1 (10, Carry_On);
      Tick_1 (14, Carry_On);
      Expect_Ran ("both ran", 2);
      Tick_1 (15, Begin_Start);
      End_Test (Processor_Restart);
      Tick_1 (16, Load_Tasks);
      Tick_1 (17, Carry_On);
      Expect_Ran ("both initialise again", 2);
   end Failed_Step;

   procedure Other_Processor is
   begin
      Ran := 0;
      Wisher := No_Task;
      This_Node.Switch_On (2, Time_First);
      Tick_2 (0, Stand_Still);
      Tick_1 (0, Begin_Start);
      Tick_2 (1, Stand_Still);
      End_Test (Cold_Start);
      Tick_1 (1, Load_Tasks);
      Tick_2 (2, Load_Tasks);
      Expect_Ran ("both initialise theirs", 4);

      --  A step of the second processor fails. The first one's task, due at
      --  that tick, does not run any more.
      Tick_1 (10, Carry_On);
      Wisher := First;
      Wish := Processor_Restart;
      Tick_2 (10, Carry_On);
      Expect_Ran ("one each", 2);
      Tick_1 (14, Stand_Still);
      Tick_2 (14, Stand_Still);
      Tick_1 (15, Begin_Start);
      Tick_2 (16, Stand_Still);
      Expect_Ran ("nobody", 0);
      End_Test (Processor_Restart);
      Tick_2 (17, Load_Tasks);
      Tick_2 (18, Carry_On);
      Tick_1 (18, Load_Tasks);
      Expect_Ran ("both initialise theirs again", 4);
   end Other_Processor;

   procedure Sums is
      Watched : Node;
   begin
      Watched.Switch_On (2, Time_First + Seconds (5));
      Expect
        ("tick 0", Watched.Switched_On_At = Time_First + Seconds (5), True);
      Expect_Number ("processors", Integer (Watched.Processors), 2);
      Expect ("no overruns", Watched.Overruns, 0);
      Watched.Note_Tick (1, 7, 3);
      Watched.Note_Tick (2, 6, 4);
      Expect ("overruns of both", Watched.Overruns, 7);
      Expect ("the latest tick of either", Watched.Now, 7);
      Watched.Note_Tick (2, 9, 4);
      Expect ("the latest tick of either", Watched.Now, 9);
      Watched.Note_Tick (1, 8, 5);
      Expect ("overruns of both", Watched.Overruns, 9);
      Watched.Note_Tick (3, 9, 2);
      Watched.Note_Tick (4, 9, 1);
      Expect ("overruns of four", Watched.Overruns, 12);
      Expect ("the latest tick of either", Watched.Now, 9);
      Watched.Note_Tick (1, 9, Count'Last - 7);
      Expect ("all that can be counted", Watched.Overruns, Count'Last);
      Watched.Note_Tick (1, 9, Count'Last);
      Expect ("no more can be counted", Watched.Overruns, Count'Last);
   end Sums;

   procedure Absent_Processor is
      Lone       : Node;
      Next_Order : Order;
   begin
      --  An unused seat has no work, and no processor waits for it.
      Lone.Switch_On (1, Time_First);
      Lone.Look (2, Next_Order);
      Expect ("before the start", Next_Order.Name, Stand_Still);
      Lone.Look (1, Next_Order);
      Expect ("the master", Next_Order.Name, Begin_Start);
      Lone.Note_Tested (True, Numbers_For ((1 => True, others => False)));
      Lone.Look (2, Next_Order);
      Expect ("after the test", Next_Order.Name, Stand_Still);
      Lone.Look (1, Next_Order);
      Expect ("the master", Next_Order.Name, Load_Tasks);
      Lone.Look (2, Next_Order);
      Expect ("when tasks run", Next_Order.Name, Stand_Still);
      Lone.Look (1, Next_Order);
      Expect ("the master", Next_Order.Name, Carry_On);
   end Absent_Processor;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "INI-1 a start is granted at the tick after the wish, once",
         Request_While_Idle'Access);
      Add
        (Suite, "INI-1 D-9 a start waits for the end of the step",
         Request_During_Step'Access);
      Add
        (Suite, "KRN-6 a failed step brings a processor restart",
         Failed_Step'Access);
      Add
        (Suite, "KRN-5 KRN-6 EXT-4 a failed step of either processor, too",
         Other_Processor'Access);
      Add
        (Suite, "FRM-4 EXT-4 a node's overruns are those of its processors",
         Sums'Access);
      Add
        (Suite, "EXT-4 no processor waits for an absent one",
         Absent_Processor'Access);
   end Add_To;

end Shared_Nodes_Tests;
