--  SPDX-License-Identifier: Apache-2.0

--  GSC: the ground station core (report, section 5, figure 2).
--
--  This package wires the node: it declares the boards and the variables
--  between the tasks, and connects each task to those that it consumes and
--  produces (SET-2).

with Devices.Memory_Bus; use Devices.Memory_Bus;
with Devices.Processor_Memories;
with Telemetry.Shared_Boards;
with URVOS;              use URVOS;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Node_Software;
with URVOS.Task_Lists;
with URVOS.Task_Trees;   use URVOS.Task_Trees;
with URV.AD_Boards;
with URV.AD_Task;
with URV.ADINT_Handler;
with URV.Codecs;         use URV.Codecs;
with URV.CORE_Task;
with URV.Downlink_Input;
with URV.GDCIN_Task;
with URV.GDCOUT_Task;
with URV.Log_Receivers;
with URV.LOG_Task;
with URV.Mailboxes;      use URV.Mailboxes;
with URV.Self_Test_Task;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors;
with URV.Shared_Schedules;
with URV.Shared_Seals;
with URV.Shared_Status;
with URV.Start_Routines;
with URV.TELIN_Task;
with URV.TELOUT_Task;
with URV.Type_Codes;     use URV.Type_Codes;

package GSC with SPARK_Mode is

   --  Boards

   AD_Board : URV.AD_Boards.Board;

   CORE_Memory : URV.Shared_CORE_Memory.Board;

   Telemetry_Board : Telemetry.Shared_Boards.Shared_Board
     (Role            => Telemetry.Ground,
      Transmit_Length => Uplink.Block_Length,
      Receive_Length  => Downlink.Block_Length);

   Processor_Board : constant Board_Number := 1;

   package Memories is new Devices.Processor_Memories (Processor_Board);

   --  Variables, each with one producer and one consumer

   ADINT_Variable    : For_Stick_Words.Variable;
   AD_Variable       : For_Stick_Images.Variable;
   TELIN_Variable    : For_Downlink.Variable;
   Uplink_Variable   : For_Uplink.Variable;
   Downlink_Variable : For_Framed_Downlink.Variable;
   TELOUT_Variable   : For_Uplink.Variable;

   --  The console's orders besides the sticks: the latest block of another
   --  kind (EXT-2).
   Console_Orders : For_Uplink.Variable;

   --  The latest block of the aircraft's flight recorder, for the station
   --  (FTI-10).
   Recorder_Blocks : For_Downlink.Variable;

   Errors : URV.Shared_Errors.Shared_Log;

   Sealing : URV.Shared_Seals.Shared_Seal (Telemetry.Ground);

   Status : URV.Shared_Status.Status;

   --  When the tasks run: set before the node is switched on (FRM-5).
   Schedule : URV.Shared_Schedules.Store;

   --  Tasks

   package ADINT is new URV.ADINT_Handler
     (For_Stick_Words, AD_Board, ADINT_Variable, Errors);

   package AD is new URV.AD_Task
     (For_Stick_Words, For_Stick_Images, ADINT_Variable, AD_Variable,
      Errors, Schedule, ADINT.Begin_Scan, Fast_Scans => 1);

   package TELIN is new URV.TELIN_Task
     (URV.Downlink_Input, For_Downlink, Telemetry_Board, TELIN_Variable,
      Sealing, Errors);

   package Log_Receiver is new URV.Log_Receivers (CORE_Memory);

   package GDCIN is new URV.GDCIN_Task
     (TELIN_Variable, Downlink_Variable, Recorder_Blocks, Errors,
      Log_Receiver.Take_Piece, Log_Receiver.Miss_Piece);

   package GDCOUT is new URV.GDCOUT_Task
     (AD_Variable, Uplink_Variable, TELOUT_Variable, Console_Orders, Status,
      Errors, Stick_Codes);

   package TELOUT is new URV.TELOUT_Task
     (For_Uplink, TELOUT_Variable, Telemetry_Board, Sealing, Errors,
      Uplink.Words_Of);

   package CORE is new URV.CORE_Task
     (Uplink_Variable, Downlink_Variable, CORE_Memory, Errors);

   package LOG is new URV.LOG_Task (Telemetry_Board, CORE_Memory, Errors);

   package SELF_TEST is new URV.Self_Test_Task
     (Last            => Last_ROM_Long,
      Longs_Per_Frame => ROM_Longs_Per_Frame,
      CORE_Memory     => CORE_Memory,
      Node_Status     => Status,
      Errors          => Errors,
      Read_ROM        => Memories.Read_ROM);

   --  The tasks, in order of priority: when they run, and on which of four
   --  processors (FRM-2, FRM-5, SET-1, KRN-5, EXT-4). In the report's schedule
   --  the converter's task is on the first processor, data collection on the
   --  second, the link's on the third, CORE's on the fourth. In the fast
   --  schedule each consumer runs right after its producer, on the same
   --  processor. No task is released in the last minor frame.

   type Task_Name is
     (AD_Task,
      TELIN_Task,
      GDCIN_Task,
      GDCOUT_Task,
      TELOUT_Task,
      CORE_Task,
      LOG_Task,
      SELF_TEST_Task);

   type Task_Table is array (Task_Name) of Task_Attributes;

   Task_List : constant Task_Table :=
     (AD_Task        => (Report => (0, 1), Fast => (0, 3)),
      TELIN_Task     => (Report => (0, 3), Fast => (5, 1)),
      GDCIN_Task     => (Report => (1, 2), Fast => (5, 1)),
      GDCOUT_Task    => (Report => (1, 2), Fast => (0, 3)),
      TELOUT_Task    => (Report => (2, 3), Fast => (0, 3)),
      CORE_Task      => (Report => (4, 4), Fast => (5, 1)),
      LOG_Task       => (Report => (5, 4), Fast => (7, 2)),
      SELF_TEST_Task => (Report => (6, 1), Fast => (8, 4)));

   package Tasks is
     new URVOS.Task_Lists (Task_Name, Task_Table, Task_List);

   --  Runs a task's next step: its initialisation, or the transaction of a
   --  frame. The task then sleeps until its offset in the next major frame
   --  (FRM-3).
   procedure Run_Step
     (Name      : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   --  The start of the node

   procedure Reset_Variables;

   procedure Restart_Variables;

   --  The ground reads CORE's status directly (TST-4).
   procedure Report_Refused_Start is null;

   package Starts is new URV.Start_Routines
     (Memories, CORE_Memory, Telemetry_Board, Sealing, Errors,
      Reset_Variables, Restart_Variables, Report_Refused_Start);

   --  For the kernel: sets the time of reports, and reports an overrun.

   procedure Set_Time (Now : Clock_Tick)
   with Inline, Global => (In_Out => Errors);

   procedure Report_Overrun (Id : Task_Id)
   with Global => (In_Out => Errors);

   package Software is new URVOS.Node_Software
     (Tasks, Run_Step, Starts.Begin_Again, Set_Time, Report_Overrun);

end GSC;
