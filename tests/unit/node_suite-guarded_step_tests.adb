--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time; use Ada.Real_Time;
with GNAT.OS_Lib;

with Checks;                   use Checks;
with Expectations;             use Expectations;
with Host.Memory_Hardware;
with Host.Text_Output;
with MCS;
with Partitions.Clocks;
with Partitions.Exceptions;
with Partitions.Guards;
with Partitions.Measurements;
with Partitions.Reports;
with URVOS;
with URVOS.Frames;             use URVOS.Frames;
with URVOS.Kernel_Calls;       use URVOS.Kernel_Calls;
with URVOS.Starts;             use URVOS.Starts;

separate (Node_Suite)
package body Guarded_Step_Tests is

   use type Partitions.Measurements.Total;
   use type URVOS.Count;

   --  The tests, in order.
   procedure Whole_Steps;
   procedure Times_Taken;
   procedure Long_Times;
   procedure Times_Written;
   procedure Exceptions;
   procedure Pauses;
   procedure Interrupts;
   procedure Broken_Starts;

   --  A task that counts its steps and fails on request, and one whose
   --  transaction takes a set time.
   type Task_Name is (Counting, Busy);

   procedure Run_Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   procedure Run_Transaction;
   procedure Observe (Who : Task_Name);
   procedure Fail;

   Is_Broken : Boolean := False;

   --  The node has stopped for a while.
   Is_Late : Boolean := False;

   function Has_Stood_Still return Boolean is (Is_Late);

   Begun, Run, Observed, Failures : Natural := 0;

   type Distributions is
     array (Task_Name) of Partitions.Measurements.Distribution;

   Costs, Responses : Distributions;

   procedure Step is new Partitions.Guards.Step
     (Task_Name, Distributions, Costs, Responses, Has_Stood_Still, Run_Step,
      Observe, Fail);

   Busy_Time : constant Time_Span := Milliseconds (3);

   procedure Be_Busy;

   --  The first phases of a start.
   procedure Begin_Again
     (Condition : Start_Condition; Now : Clock_Tick; Passed : out Boolean);

   procedure Request_Start (Condition : Start_Condition);

   type Wish is record
      Is_There  : Boolean         := False;
      Condition : Start_Condition := Cold_Start;
   end record;

   Wished : Wish;

   procedure Start is new Partitions.Guards.Start
     (Begin_Again, Request_Start);

   --  An interrupt of the processor.
   procedure Raise_Processor_Exception;

   Raised : Natural := 0;

   procedure Interrupt is new Partitions.Guards.Call
     (Run_Transaction, Raise_Processor_Exception);

   procedure Expect_Step
     (What : String; First_Run : Boolean; Failed : Boolean);

   procedure Run_Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call)
   is
      pragma Unreferenced (Now);
   begin
      Call := (Sleep_Call, Until_Tick => 5, others => <>);
      if Who = Busy then
         Be_Busy;
      elsif not First_Run then
         Run_Transaction;
      elsif Is_Broken then
         raise Program_Error;
      else
         Begun := Begun + 1;
      end if;
   end Run_Step;

   procedure Run_Transaction is
   begin
      if Is_Broken then
         raise Constraint_Error;
      end if;
      Run := Run + 1;
   end Run_Transaction;

   procedure Be_Busy is
      Ends : constant Time := Clock + Busy_Time;
   begin
      while Clock < Ends loop
         null;
      end loop;
   end Be_Busy;

   procedure Begin_Again
     (Condition : Start_Condition; Now : Clock_Tick; Passed : out Boolean)
   is
   begin
      Expect_Number ("the tick", Integer (Now), 77);
      Wished.Is_There := False;
      MCS.Starts.Begin_Again (Condition, Now, Passed);
   end Begin_Again;

   procedure Request_Start (Condition : Start_Condition) is
   begin
      Wished := (True, Condition);
   end Request_Start;

   procedure Raise_Processor_Exception is
   begin
      Raised := Raised + 1;
   end Raise_Processor_Exception;

   procedure Observe (Who : Task_Name) is
   begin
      if Who = Counting then
         Observed := Observed + 1;
      end if;
   end Observe;

   procedure Fail is
   begin
      Failures := Failures + 1;
   end Fail;

   procedure Expect_Step
     (What : String; First_Run : Boolean; Failed : Boolean)
   is
      Before : constant Natural := Failures;
      Call   : Kernel_Call;
   begin
      Partitions.Clocks.Switch_On;
      Step (Counting, First_Run, 0, Call);
      Expect (What & " has failed", Failures = Before + 1, Failed);
      Expect (What & " has not", Failures = Before, not Failed);
      Expect
        (What & " ends with its call", Call.Name = Sleep_Call, not Failed);
   end Expect_Step;

   procedure Whole_Steps is
   begin
      Is_Broken := False;
      Begun := 0;
      Run := 0;
      Observed := 0;
      Expect_Step ("the first step", First_Run => True, Failed => False);
      Expect_Number ("initialised", Begun, 1);
      Expect_Number ("run in the first step", Run, 0);
      for Frame in 1 .. 3 loop
         Expect_Step ("a step", First_Run => False, Failed => False);
      end loop;
      Expect_Number ("initialised again", Begun, 1);
      Expect_Number ("transactions", Run, 3);
      Expect_Number ("seen", Observed, 3);
      Expect ("measured", Costs (Counting).Summed_Up.Number = 3, True);
      Expect
        ("response measured", Responses (Counting).Summed_Up.Number = 3, True);
   end Whole_Steps;

   --  The time measured is at least the transaction's, and at most the
   --  caller's, on a machine of any speed.
   procedure Times_Taken is
      Tick : Time;
      Call : Kernel_Call;
      Most : Partitions.Measurements.Measure;
   begin
      Failures := 0;
      for Frame in 1 .. 5 loop
         Tick := Clock;
         Partitions.Clocks.Switch_On;
         Be_Busy;
         Step (Busy, False, 0, Call);
         Most := Partitions.Measurements.Measure
           (To_Duration (Clock - Tick) * 1.0E7);
         Expect_Number ("failures", Failures, 0);
         Expect
           ("cost is no less", Costs (Busy).Summed_Up.Minimum >= 30_000, True);
         Expect
           ("response is no less",
            Responses (Busy).Summed_Up.Minimum >= 60_000, True);
         if Frame = 1 then
            Expect
              ("cost is no more",
               Costs (Busy).Summed_Up.Maximum + 30_000 <= Most, True);
            Expect
              ("response is no more",
               Responses (Busy).Summed_Up.Maximum <= Most, True);
         end if;
      end loop;
   end Times_Taken;

   procedure Times_Written is
      use GNAT.OS_Lib;

      File   : File_Descriptor;
      Name   : String_Access;
      To     : Host.Text_Output.Writer;
      Result : Partitions.Reports.Report;
      Text   : String (1 .. 200);
      Length : Integer;
      Gone   : Boolean;
   begin
      Create_Temp_File (File, Name);
      Host.Text_Output.Attach (To, File, Name.all);
      Partitions.Reports.Begin_Report (Result, To);
      Partitions.Reports.Put_Times
        (Result, To, "cost_us",
         (Number => 7, Minimum => 9, Median => 30, P99 => 1_234,
          Maximum => 50_001));
      Partitions.Reports.End_Report (Result, To);
      Host.Text_Output.Close (To);

      File := Open_Read (Name.all, Binary);
      Length := Read (File, Text'Address, Text'Length);
      Close (File);
      Delete_File (Name.all, Gone);
      Expect
        ("the summary is right",
         Gone and then Text (1 .. Length) =
           "{" & ASCII.LF
           & "  ""cost_us"": {""min"": 0.9, ""median"": 3, ""p99"": 123.4,"
           & " ""max"": 5000.1, ""measured"": 7}" & ASCII.LF
           & "}" & ASCII.LF,
         True);
   end Times_Written;

   procedure Exceptions is
      Before : constant Natural := Observed;
      Told   : constant URVOS.Count := Partitions.Exceptions.Number;
   begin
      Is_Broken := True;
      Expect_Step ("a first step", First_Run => True, Failed => True);
      Expect_Step ("a later step", First_Run => False, Failed => True);
      Expect_Number ("seen", Observed, Before);
      Is_Broken := False;
      Expect_Step ("the next step", First_Run => False, Failed => False);
      Expect ("both are told", Partitions.Exceptions.Number = Told + 2, True);
   end Exceptions;

   procedure Pauses is
      Before_Run   : constant Natural := Run;
      Before_Begun : constant Natural := Begun;
   begin
      Is_Broken := False;
      Is_Late := True;
      Expect_Step ("a step", First_Run => False, Failed => True);
      Expect_Number ("transactions", Run, Before_Run);

      --  The first step sends nothing on.
      Expect_Step ("a first step", First_Run => True, Failed => False);
      Expect_Number ("initialised", Begun, Before_Begun + 1);
      Is_Late := False;
      Expect_Step ("the next step", First_Run => False, Failed => False);
   end Pauses;

   procedure Interrupts is
      Before : constant Natural := Run;
   begin
      Raised := 0;
      Is_Broken := False;
      Interrupt;
      Expect_Number ("handled", Run, Before + 1);
      Expect_Number ("exceptions of a good one", Raised, 0);
      Is_Broken := True;
      Interrupt;
      Is_Broken := False;
      Expect_Number ("exceptions of a bad one", Raised, 1);
      Interrupt;
      Expect_Number ("handled again", Run, Before + 2);
   end Interrupts;

   --  The memory does not answer the self-test. A processor restart reads no
   --  memory (SAF-12).
   procedure Broken_Starts is
      Told   : constant URVOS.Count := Partitions.Exceptions.Number;
      Passed : Boolean;
   begin
      Host.Memory_Hardware.Repair (2);
      for Condition in Cold_Start .. Warm_Reset loop
         Host.Memory_Hardware.Fail_Next_Read (2);
         Start (Condition, 77, Passed);
         Expect (Condition'Image & " passed", Passed, False);
         Expect
           (Condition'Image & " restarts",
            Wished =
              (True,
               (if Condition = Cold_Start then Cold_Start
                else Processor_Restart)),
            True);
         Start (Wished.Condition, 77, Passed);
         Expect (Condition'Image & " passed then", Passed, True);
         Expect (Condition'Image & " is over", Wished.Is_There, False);
      end loop;
      Host.Memory_Hardware.Fail_Next_Read (2);
      Start (Processor_Restart, 77, Passed);
      Expect ("a processor restart passed", Passed, True);
      Host.Memory_Hardware.Repair (2);
      Expect
        ("a planted fault is not told", Partitions.Exceptions.Number = Told,
         True);
   end Broken_Starts;

   --  A Duration has room for 9,223 s of microseconds.
   procedure Long_Times is
      use type Host.Microseconds;

      Rest : constant := 250;
   begin
      for Hours in 0 .. 1_000 loop
         declare
            Span  : constant Time_Span :=
              Seconds (3_600 * Hours) + Microseconds (Rest);
            Whole : constant Host.Microseconds :=
              Host.Microseconds (Hours) * 3_600 * 1_000_000 + Rest;
         begin
            Expect
              (Hours'Image & " h in microseconds",
               Partitions.Clocks.In_Microseconds (Span) = Whole, True);
            Expect
              (Hours'Image & " h in tenths of them",
               Partitions.Clocks.Tenths_Of_Microseconds (Span)
                 = 10 * Partitions.Measurements.Measure (Whole), True);
            Expect
              (Hours'Image & " h in seconds",
               Host.In_Seconds (Whole) = To_Duration (Span), True);
         end;
      end loop;
      Expect
        ("none before its beginning",
         Partitions.Clocks.Tenths_Of_Microseconds (-Seconds (1)) = 0, True);
   end Long_Times;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "RTP-1 a step initialises first, then runs transactions",
         Whole_Steps'Access);
      Add
        (Suite, "RTP-1 a step's times are those that it took",
         Times_Taken'Access);
      Add
        (Suite, "RTP-1 times of weeks have room", Long_Times'Access);
      Add
        (Suite, "RTP-2 a summary's times are in microseconds",
         Times_Written'Access);
      Add
        (Suite, "KRN-6 a step that raises an exception has failed",
         Exceptions'Access);
      Add
        (Suite, "SAF-4 a step of a node that stood still is not made",
         Pauses'Access);
      Add
        (Suite, "KRN-6 an interrupt that raises one restarts the processor",
         Interrupts'Access);
      Add
        (Suite, "KRN-6 a start that raises an exception is repeated",
         Broken_Starts'Access);
   end Add_To;

end Guarded_Step_Tests;
