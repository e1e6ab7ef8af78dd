--  SPDX-License-Identifier: Apache-2.0

with Checks;           use Checks;
with Expectations;     use Expectations;
with GSC.Virtual_Time;
with MCS.Virtual_Time;
with Host.Memory_Hardware;
with Node_Rig;         use Node_Rig;
with Telemetry;        use Telemetry;
with URVOS;            use URVOS;
with URVOS.Frames;     use URVOS.Frames;
with URVOS.Starts;
with URVOS.Task_Trees; use URVOS.Task_Trees;
with URV.Buffers;      use URV.Buffers;
with URV.CORE_Memory;  use URV.CORE_Memory;
with URV.Errors;       use URV.Errors;
with URV.Shared_Status;

separate (Node_Suite)
package body In_Flight_Tests is

   --  The tests, in order.
   procedure Sound_ROM;
   procedure Spoilt_ROM;
   procedure New_Status;
   procedure Results_In_CORE;
   procedure Late_Tasks;

   --  The longs of the ROM checked in a frame, and the frames for the whole
   --  ROM.
   Longs_A_Frame : constant := 16;
   Frames_A_Pass : constant := 16#4000# / Longs_A_Frame;

   --  The bit of the error/status word for a ROM difference.
   ROM_Bit : constant Word := 2;

   --  Runs both nodes' tasks for some frames while the boards' hardware stops.
   procedure Run_Tasks (Frames : Positive);

   --  Runs a pass except for its last two frames. All tasks run in the first
   --  frames; in the other thousand only the self-test does.
   procedure Run_Most_Of_A_Pass;

   --  The node's own bits in its error/status word.
   function Status_Of (Node : Station) return Word is
     (case Node is
         when Ground   => GSC.Status.Contents,
         when Aircraft => MCS.Status.Contents);

   procedure Expect_ROM_Result
     (What         : String;
      Node         : Station;
      Good, Bad    : Word;
      Bits         : Word);

   procedure Run_Tasks (Frames : Positive) is
   begin
      for Ticks in 1 .. Frames * Ticks_Per_Major_Frame loop
         Now := Advanced (Now);
         GSC.Virtual_Time.Clock_Interrupt (Now);
         if Now >= 3 then
            MCS.Virtual_Time.Clock_Interrupt (Now - 3);
         end if;
      end loop;
   end Run_Tasks;

   procedure Run_Most_Of_A_Pass is
      By_All : constant := 4;
   begin
      --  A node's tasks are released after its first frame.
      Run_Tasks (By_All + 1);
      Expect_Number
        ("checked on the ground",
         Integer (GSC.SELF_TEST.Progress.Contents.Position),
         By_All * Longs_A_Frame);
      Expect_Number
        ("checked in the air",
         Integer (MCS.SELF_TEST.Progress.Contents.Position),
         By_All * Longs_A_Frame);
      for Frame in By_All + 1 .. Frames_A_Pass - 2 loop
         GSC.SELF_TEST.Run_Transaction;
         MCS.SELF_TEST.Run_Transaction;
      end loop;
   end Run_Most_Of_A_Pass;

   procedure Expect_ROM_Result
     (What         : String;
      Node         : Station;
      Good, Bad    : Word;
      Bits         : Word)
   is
      Where : constant String := Node'Image & ", " & What;
   begin
      Expect
        (Where & ": passes", CORE_Of (Node).Status (ROM_Passes), Good);
      Expect
        (Where & ": failures", CORE_Of (Node).Status (ROM_Failures), Bad);
      Expect (Where & ": status", Status_Of (Node), Bits);
   end Expect_ROM_Result;

   procedure Sound_ROM is
   begin
      Switch_On;
      Run_Most_Of_A_Pass;
      for Node in Station loop
         Expect_ROM_Result ("before the first pass's end", Node, 0, 0, 0);
      end loop;
      Run_Tasks (2);
      for Node in Station loop
         Expect_ROM_Result ("after the first pass", Node, 1, 0, 0);
         Expect
           ("failures in the log",
            Logs.History_Of (Log_Of (Node), ROM_Check_Failed).Occurrences,
            0);
      end loop;
   end Sound_ROM;

   procedure Spoilt_ROM is
   begin
      Switch_On;
      Host.Memory_Hardware.Spoil_ROM (1, 16#4321#, 16#10#);
      Host.Memory_Hardware.Spoil_ROM (2, 16#FEDC#, 16#01#);
      Run_Most_Of_A_Pass;
      Run_Tasks (2);
      for Node in Station loop
         Expect_ROM_Result ("spoilt", Node, 0, 1, ROM_Bit);
         Expect
           ("failures in the log",
            Logs.History_Of (Log_Of (Node), ROM_Check_Failed).Occurrences,
            1);
         Expect
           ("how many, in the log",
            Logs.History_Of (Log_Of (Node), ROM_Check_Failed).Last_Detail,
            1);
      end loop;

      --  The other node's CORE shows it in the error/status word.
      Fly (4);
      Expect
        ("the ground's, in the air",
         CORE_Of_MCS.Uplink (Error_Status), ROM_Bit);
      Expect
        ("the aircraft's, on the ground",
         CORE_Of_GSC.Downlink (Error_Status), ROM_Bit);

      --  A start clears it until the next pass.
      Host.Memory_Hardware.Repair (1);
      Host.Memory_Hardware.Repair (2);
      for Node in Station loop
         Start_Again (Node, Starts.Warm_Reset);
         Expect ("after a start", Status_Of (Node), 0);
      end loop;
   end Spoilt_ROM;

   procedure New_Status is
      Status : URV.Shared_Status.Status;
   begin
      Expect ("new", Status.Contents, 0);
      Status.Write (ROM_Bit);
      Expect ("written", Status.Contents, ROM_Bit);
   end New_Status;

   procedure Results_In_CORE is

      --  The tasks' state with two slices left.
      Ground_Check   : GSC.SELF_TEST.Checks.Check;
      Aircraft_Check : MCS.SELF_TEST.Checks.Check;

      --  Expects that a good pass ends after this number of frames.
      procedure Expect_Written
        (Good, Bad : Count; Good_Word, Bad_Word, Bits : Word);

      procedure Expect_Written
        (Good, Bad : Count; Good_Word, Bad_Word, Bits : Word) is
      begin
         Switch_On;
         Ground_Check.Good_Passes := Good;
         Ground_Check.Bad_Passes := Bad;
         GSC.SELF_TEST.Progress.Write (Ground_Check);
         Aircraft_Check.Good_Passes := Good;
         Aircraft_Check.Bad_Passes := Bad;
         MCS.SELF_TEST.Progress.Write (Aircraft_Check);
         Run_Tasks (3);
         for Node in Station loop
            Expect_ROM_Result
              ("after" & Good'Image & Bad'Image, Node, Good_Word, Bad_Word,
               Bits);
         end loop;
      end Expect_Written;
   begin
      Switch_On;
      Run_Most_Of_A_Pass;
      Ground_Check := GSC.SELF_TEST.Progress.Contents;
      Aircraft_Check := MCS.SELF_TEST.Progress.Contents;

      --  A count is one word and stops at its last value.
      Expect_Written (2, 0, 3, 0, 0);
      Expect_Written (0, 1, 1, 1, ROM_Bit);
      Expect_Written (65_533, 65_535, 65_534, 65_535, ROM_Bit);
      Expect_Written (65_534, 65_536, 65_535, 65_535, ROM_Bit);
      Expect_Written (65_535, 65_537, 65_535, 65_535, ROM_Bit);
      Expect_Written (Count'Last, Count'Last, 65_535, 65_535, ROM_Bit);
   end Results_In_CORE;

   procedure Late_Tasks is
      Before, Late : Count;
   begin
      --  Both clocks jump by more than a frame: each task is late and has
      --  missed its next release.
      Switch_On;
      Before := GSC.Virtual_Time.Overruns;
      GSC.Virtual_Time.Clock_Interrupt (37);
      Late := GSC.Virtual_Time.Overruns - Before;
      Expect ("late on the ground", Late, 2 * GSC.Task_List'Length);
      Expect
        ("in the ground's log",
         Logs.History_Of (Log_Of (Ground), Task_Overrun).Occurrences, Late);
      Expect
        ("the last of them, of the ground",
         Logs.History_Of (Log_Of (Ground), Task_Overrun).Last_Detail,
         Word (GSC.Tasks.Id_Of (GSC.Task_Name'Last)));

      --  The number of processors does not change the number of late tasks.
      for Processors in Processor_Number loop
         Switch_On (Processors);
         Before := MCS.Virtual_Time.Overruns;
         MCS.Virtual_Time.Clock_Interrupt (37);
         Late := MCS.Virtual_Time.Overruns - Before;
         Expect ("late in the air", Late, 2 * MCS.Task_List'Length);
         Expect
           ("in the aircraft's log",
            Logs.History_Of (Log_Of (Aircraft), Task_Overrun).Occurrences,
            Late);
         if Processors = 1 then
            Expect
              ("the last of them, of the aircraft",
               Logs.History_Of (Log_Of (Aircraft), Task_Overrun).Last_Detail,
               Word (MCS.Tasks.Id_Of (MCS.Task_Name'Last)));
         end if;
      end loop;
   end Late_Tasks;

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite) is
   begin
      Add
        (Suite, "TST-3 INI-6 CORE counts each node's passes through its ROM",
         Sound_ROM'Access);
      Add
        (Suite, "TST-3 TST-4 a node reports that its ROM differs",
         Spoilt_ROM'Access);
      Add
        (Suite, "TST-4 a node's status is no error without a report",
         New_Status'Access);
      Add
        (Suite, "TST-3 INI-6 the counts in CORE stay at their last value",
         Results_In_CORE'Access);
      Add
        (Suite, "FRM-4 KRN-5 late tasks are counted and logged, on each "
         & "processor", Late_Tasks'Access);
   end Add_To;

end In_Flight_Tests;
