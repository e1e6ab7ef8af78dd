--  SPDX-License-Identifier: Apache-2.0

with Checks;             use Checks;
with Expect_Value;
with Expectations;       use Expectations;
with URVOS;              use URVOS;
with URVOS.Bare_Nodes;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Node_Software;
with URVOS.Starts;       use URVOS.Starts;
with URVOS.Task_Lists;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

package body Bare_Nodes_Tests is

   --  The tests, in order.
   procedure Begins_Cold;
   procedure Runs_In_Frames;
   procedure Late_Ticks;
   procedure Overrun;
   procedure Interrupted_Start;
   procedure Refusal;
   procedure Held_Frame;
   procedure Second_Look;

   procedure Expect is new Expect_Value (Start_Condition);

   --  Two tasks, at minor frames 0 and 4

   type Task_Name is (Early, Late);
   type Task_Table is array (Task_Name) of Task_Attributes;
   Table : constant Task_Table :=
     (Early => (Report => (0, 1), Fast => (0, 1)),
      Late  => (Report => (4, 1), Fast => (4, 1)));
   package Tasks is new URVOS.Task_Lists (Task_Name, Task_Table, Table);

   --  The events of the test.
   Runs          : array (Task_Name) of Natural;
   Starts        : Natural;
   Last_Start    : Start_Condition;
   Overruns_Seen : Natural;
   Time_Told     : Clock_Tick;

   --  The plan: the ticks during a task's next step, the self-test's result,
   --  the EXITs of the early task, and the length of the present frame.
   Ticks_In_Step : Natural;
   Test_Passes   : Boolean;
   Exits         : Natural;
   Wanted        : Frame_Request;

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

   procedure Report_Overrun (Who : Task_Id);

   procedure Look_At_Frame
     (Ticks : Tick_Count; Request : in out Frame_Request);

   package Software is new URVOS.Node_Software
     (Tasks, Run_Step, Begin_Again, Set_Time, Report_Overrun, Look_At_Frame);

   package Node is new URVOS.Bare_Nodes (Software);

   --  As the machine does

   procedure Run_Steps;
   procedure Serve;

   --  The node is switched on, again: its clock runs on.
   procedure Start (Condition : Start_Condition := Warm_Reset);

   --  Makes this number of ticks, each served at once.
   procedure Tick (Number : Positive := 1);

   --  Runs up to the start of a major frame, when the early task runs.
   procedure Tick_To_Frame;

   procedure Run_Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call)
   is
      pragma Unreferenced (Now);
   begin
      Call :=
        (Next_Frame_Call, Offset => Table (Who) (Report).Offset,
         others => <>);
      if not First_Run then
         Runs (Who) := Runs (Who) + 1;
         if Who = Early and then Exits > 0 then
            Exits := Exits - 1;
            Call := (Name => Exit_Call, others => <>);
         end if;
      end if;
      for Each in 1 .. Ticks_In_Step loop
         Node.Clock_Interrupt;
      end loop;
      Ticks_In_Step := 0;
   end Run_Step;

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean)
   is
      pragma Unreferenced (Now);
   begin
      Starts := Starts + 1;
      Last_Start := Condition;
      Passed := Test_Passes;
   end Begin_Again;

   procedure Set_Time (Now : Clock_Tick) is
   begin
      Time_Told := Now;
   end Set_Time;

   procedure Report_Overrun (Who : Task_Id) is
      pragma Unreferenced (Who);
   begin
      Overruns_Seen := Overruns_Seen + 1;
   end Report_Overrun;

   procedure Look_At_Frame
     (Ticks : Tick_Count; Request : in out Frame_Request)
   is
   begin
      Expect_Number ("ticks told at once", Ticks, 1);
      Request := Wanted;
   end Look_At_Frame;

   procedure Run_Steps is
      Runs_On : Boolean;
   begin
      while not Node.Is_Idle loop
         Node.Run_Step (Runs_On);
         exit when Runs_On;
      end loop;
   end Run_Steps;

   procedure Serve is
   begin
      Node.Serve;
      Run_Steps;
   end Serve;

   procedure Start (Condition : Start_Condition := Warm_Reset) is
   begin
      Runs := (others => 0);
      Starts := 0;
      Overruns_Seen := 0;
      Ticks_In_Step := 0;
      Test_Passes := True;
      Exits := 0;
      Wanted := No_Request;
      Node.Begin_Start (Condition);
      Expect ("work after a wish", Node.Has_Work, True);
      Serve;
      Expect ("work after a start", Node.Has_Work, False);
   end Start;

   procedure Tick (Number : Positive := 1) is
   begin
      for Each in 1 .. Number loop
         Node.Clock_Interrupt;
         Expect ("work after a tick", Node.Has_Work, True);
         Serve;
      end loop;
   end Tick;

   procedure Tick_To_Frame is
   begin
      loop
         Tick;
         exit when Minor_Frame_Of (Time_Told) = 0;
      end loop;
   end Tick_To_Frame;

   --  It must be the first test, since no node has been switched on before.
   procedure Begins_Cold is
   begin
      Expect ("work before power up", Node.Has_Work, False);
      Start (Processor_Restart);
      Expect ("the first start", Last_Start, Cold_Start);
      Expect ("its time", Time_Told, 0);
      Start (Processor_Restart);
      Expect ("the second start", Last_Start, Processor_Restart);
   end Begins_Cold;

   procedure Runs_In_Frames is
      Begun : Clock_Tick;
   begin
      Start;
      Tick_To_Frame;
      Begun := Time_Told;
      Expect_Number ("at offset 0", Runs (Early), 1);
      Expect_Number ("not yet", Runs (Late), 0);
      Tick (4);
      Expect_Number ("at offset 4", Runs (Late), 1);
      Tick (296);
      Expect ("the time", Time_Told, Begun + 300);
      Expect_Number ("in 30 frames more", Runs (Early), 31);
      Expect_Number ("and the other", Runs (Late), 30);
      Expect_Number ("overruns", Overruns_Seen, 0);
   end Runs_In_Frames;

   procedure Late_Ticks is
      Begun  : Clock_Tick;
      Before : constant Count := Node.Overruns;
   begin
      Start;
      Tick_To_Frame;
      Begun := Time_Told;
      for Each in 1 .. 6 loop
         Node.Clock_Interrupt;
      end loop;
      Serve;
      Expect ("no tick is lost", Time_Told, Begun + 6);
      Expect_Number ("the late task runs", Runs (Late), 1);
      Expect_Number ("and is reported", Overruns_Seen, 1);
      Expect ("and counted", Node.Overruns, Before + 1);
   end Late_Ticks;

   procedure Overrun is
      Before : constant Count := Node.Overruns;
   begin
      Start;
      Tick_To_Frame;
      Tick (9);
      Ticks_In_Step := 12;
      Tick;
      Expect_Number ("a step over a frame", Overruns_Seen, 2);
      Expect ("is counted", Node.Overruns, Before + 2);
      Expect_Number ("the other task runs in its place", Runs (Late), 2);
      Tick_To_Frame;
      Tick (4);
      Expect_Number ("and in the next frame again", Runs (Late), 3);
      Expect_Number ("in time", Overruns_Seen, 2);
   end Overrun;

   procedure Interrupted_Start is
   begin
      Start;
      Tick (3);
      Node.Begin_Start (Warm_Reset);
      Node.Begin_Start (Processor_Restart);
      Serve;
      Expect_Number ("two wishes, one start", Starts, 2);
      Expect ("that of the last", Last_Start, Processor_Restart);
      Tick_To_Frame;
      Expect_Number ("the tasks run again", Runs (Early), 1);
   end Interrupted_Start;

   procedure Refusal is
   begin
      Start;
      Expect ("a good start", Node.Is_Refused, False);
      Test_Passes := False;
      Node.Begin_Start (Warm_Reset);
      Serve;
      Expect ("a failed self-test", Node.Is_Refused, True);
      Tick (40);
      Expect_Number ("no task runs", Runs (Early) + Runs (Late), 0);
      Test_Passes := True;
      Node.Begin_Start (Warm_Reset);
      Serve;
      Expect ("a later start", Node.Is_Refused, False);
      Tick_To_Frame;
      Expect_Number ("tasks run", Runs (Early), 1);
   end Refusal;

   procedure Held_Frame is
      Begun : Clock_Tick;
   begin
      Start;
      Tick_To_Frame;
      Begun := Time_Told;
      Wanted := (Begun, Frame_Length'Last);
      Tick (9);
      Expect ("the last minor frame", Time_Told, Begun + 9);
      Tick;
      Expect ("lasts a tick longer", Time_Told, Begun + 9);
      Expect_Number ("no task runs in it", Runs (Early), 1);
      Tick;
      Expect ("then the next frame begins", Time_Told, Begun + 10);
      Expect_Number ("and the task runs", Runs (Early), 2);
      Begun := Time_Told;
      Wanted := (Begun, Frame_Length'First);
      Tick (9);
      Expect ("a frame a tick shorter", Time_Told, Begun + 10);
      Expect_Number ("and the task runs at once", Runs (Early), 3);
      Expect_Number ("overruns", Overruns_Seen, 0);
   end Held_Frame;

   procedure Second_Look is
   begin
      Start;
      Exits := 2;
      Tick_To_Frame;
      Expect_Number ("one look at the tick", Runs (Early), 1);
      Expect ("it waits without work", Node.Has_Work, False);
      Run_Steps;
      Expect_Number ("one behind the interrupt", Runs (Early), 2);
      Run_Steps;
      Expect_Number ("the last one", Runs (Early), 3);
      Run_Steps;
      Expect_Number ("then it sleeps", Runs (Early), 3);
   end Second_Look;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "BRD-1 INI-1 the first start is a cold one, whatever is asked",
         Begins_Cold'Access);
      Add
        (Suite, "BRD-1 FRM-2 tasks run at their offsets, once a frame",
         Runs_In_Frames'Access);
      Add
        (Suite, "BRD-1 FRM-4 ticks that wait are served, late tasks counted",
         Late_Ticks'Access);
      Add
        (Suite, "BRD-1 FRM-4 a step longer than a frame is counted",
         Overrun'Access);
      Add
        (Suite, "BRD-1 INI-1 of two wishes for a start the last one counts",
         Interrupted_Start'Access);
      Add
        (Suite, "BRD-1 TST-4 without a self-test that passes no task runs",
         Refusal'Access);
      Add
        (Suite, "BRD-1 FRM-6 a frame is a tick longer or shorter if asked",
         Held_Frame'Access);
      Add
        (Suite, "BRD-1 KRN-3 a task that waits looks again after an interrupt",
         Second_Look'Access);
   end Add_To;

end Bare_Nodes_Tests;
