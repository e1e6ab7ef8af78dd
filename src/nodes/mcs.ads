--  SPDX-License-Identifier: Apache-2.0

--  MCS: the multiprocessor control system on board the aircraft (report,
--  section 4, figure 2).
--
--  This package wires the node: it declares the boards and the variables
--  between the tasks, and connects each task to those that it consumes and
--  produces (SET-2).

with Devices.Memory_Bus; use Devices.Memory_Bus;
with Devices.Processor_Memories;
with Telemetry.Shared_Boards;
with URVOS;              use URVOS;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Kernel_Calls; use URVOS.Kernel_Calls;
with URVOS.Node_Software;
with URVOS.Shared_Frame_Locks;
with URVOS.Task_Lists;
with URVOS.Task_Trees;   use URVOS.Task_Trees;
with URV.AD_Boards;
with URV.AD_Scans;       use URV.AD_Scans;
with URV.AD_Task;
with URV.ADINT_Handler;
with URV.Codecs;         use URV.Codecs;
with URV.CORE_Task;
with URV.Flight_Recorder;
with URV.LAW_Task;
with URV.Log_Senders;
with URV.LOG_Task;
with URV.Mailboxes;      use URV.Mailboxes;
with URV.MDCIN_Task;
with URV.MDCOUT_Task;
with URV.PWM_Boards;
with URV.PWM_Task;
with URV.Recorder_Senders;
with URV.Self_Test_Task;
with URV.Shared_Cards;
with URV.Shared_CORE_Memory;
with URV.Shared_Inputs;
with URV.Shared_Errors;
with URV.Shared_Laws;
with URV.Shared_Recorders;
with URV.Shared_Schedules;
with URV.Shared_Seals;
with URV.Shared_Surfaces;
with URV.Shared_Status;
with URV.Start_Routines;
with URV.TELIN_Task;
with URV.TELOUT_Task;
with URV.Type_Codes;     use URV.Type_Codes;
with URV.Uplink_Input;

package MCS with SPARK_Mode is

   --  Boards

   AD_Board : URV.AD_Boards.Board;

   PWM_Board : URV.PWM_Boards.Board;

   CORE_Memory : URV.Shared_CORE_Memory.Board;

   Telemetry_Board : Telemetry.Shared_Boards.Shared_Board
     (Role            => Telemetry.Aircraft,
      Transmit_Length => Downlink.Block_Length,
      Receive_Length  => Uplink.Block_Length);

   Processor_Board : constant Board_Number := 2;

   package Memories is new Devices.Processor_Memories (Processor_Board);

   --  Variables, each with one producer and one consumer

   ADINT_Variable    : For_Sensor_Words.Variable;
   AD_Variable       : For_Sensor_Images.Variable;
   TELIN_Variable    : For_Uplink.Variable;
   Uplink_Variable   : For_Uplink.Variable;
   Downlink_Variable : For_Framed_Downlink.Variable;
   TELOUT_Variable   : For_Downlink.Variable;
   Commands_Variable : For_Uplink.Variable;
   Configuration_Variable : For_Uplink.Variable;
   Recorder_Requests : For_Uplink.Variable;
   Sensors_Variable  : For_Downlink.Variable;
   PWM_Variable      : For_Uplink.Variable;

   Errors : URV.Shared_Errors.Shared_Log;

   Sealing : URV.Shared_Seals.Shared_Seal (Telemetry.Aircraft);

   Status : URV.Shared_Status.Status;

   --  When the tasks run: set before the node is switched on (FRM-5).
   Schedule : URV.Shared_Schedules.Store;

   --  Keeps the frames in step with the ground's if it was switched on before
   --  the start (FRM-6).
   Frame_Lock : URVOS.Shared_Frame_Locks.Lock;

   --  The control laws: off unless they are set on before a start (EXT-3).
   --  Law_Memory includes the ground's later configuration (EXT-2).

   Law_Settings : URV.Shared_Laws.Settings.Store;

   Law_Memory : URV.Shared_Laws.Memory_Store;

   Law_Record : URV.Shared_Laws.Records.Store;

   Surface_Health : URV.Shared_Surfaces.Healths.Store;

   --  The inputs of a test card in this frame (FTI-3).
   Test_Added : URV.Shared_Inputs.Store;

   --  The flight recorder (FTI-9, FTI-10): its length is set before the node
   --  is switched on.
   Recorder : URV.Shared_Recorders.Recorder;

   --  The running card, as the next downlink carries it (FTI-12).
   Card_Shown : URV.Shared_Cards.Store;

   --  Tasks

   package ADINT is new URV.ADINT_Handler
     (For_Sensor_Words, AD_Board, ADINT_Variable, Errors);

   package AD is new URV.AD_Task
     (For_Sensor_Words, For_Sensor_Images, ADINT_Variable, AD_Variable,
      Errors, Schedule, ADINT.Begin_Scan, Fast_Scans => Scans_In_A_Tick);

   package TELIN is new URV.TELIN_Task
     (URV.Uplink_Input, For_Uplink, Telemetry_Board, TELIN_Variable, Sealing,
      Errors);

   package MDCIN is new URV.MDCIN_Task
     (TELIN_Variable, Uplink_Variable, Commands_Variable,
      Configuration_Variable, Recorder_Requests, Errors);

   package Log_Sender is new URV.Log_Senders
     (Errors, Law_Settings, Law_Memory);

   package Recorder_Sender is new URV.Recorder_Senders
     (Recorder_Requests, Recorder);

   package MDCOUT is new URV.MDCOUT_Task
     (AD_Variable, Downlink_Variable, Sensors_Variable, TELOUT_Variable,
      Status, Card_Shown, PWM_Board, Schedule, Errors, Sensor_Codes,
      Log_Sender.Next, Recorder_Sender.Next);

   package LAW is new URV.LAW_Task
     (Commands_Variable, Sensors_Variable, PWM_Variable,
      Configuration_Variable, Law_Settings, Law_Memory, Law_Record,
      Surface_Health, Test_Added, Card_Shown, Errors);

   package PWM is new URV.PWM_Task
     (PWM_Variable, Surface_Health, Test_Added, PWM_Board, Errors);

   package TELOUT is new URV.TELOUT_Task
     (For_Downlink, TELOUT_Variable, Telemetry_Board, Sealing, Errors,
      Downlink.Words_Of);

   package CORE is new URV.CORE_Task
     (Uplink_Variable, Downlink_Variable, CORE_Memory, Errors);

   package LOG is new URV.LOG_Task (Telemetry_Board, CORE_Memory, Errors);

   --  The last act of LOG's step.
   package Flight_Recorder is new URV.Flight_Recorder
     (CORE_Memory, PWM_Board, Law_Record, Errors, Recorder);

   package SELF_TEST is new URV.Self_Test_Task
     (Last            => Last_ROM_Long,
      Longs_Per_Frame => ROM_Longs_Per_Frame,
      CORE_Memory     => CORE_Memory,
      Node_Status     => Status,
      Errors          => Errors,
      Read_ROM        => Memories.Read_ROM);

   --  The tasks, in order of priority: when they run, and on which of four
   --  processors (FRM-2, FRM-5, SET-1, KRN-5, EXT-4). In the report's schedule
   --  the converter's and the servos' tasks are on the first processor, data
   --  collection and the laws on the second, the link's on the third, CORE's
   --  on the fourth. In the fast schedule each consumer runs right after its
   --  producer, on the same processor. No task is released in the last minor
   --  frame.

   type Task_Name is
     (AD_Task,
      TELIN_Task,
      MDCIN_Task,
      MDCOUT_Task,
      LAW_Task,
      PWM_Task,
      TELOUT_Task,
      CORE_Task,
      LOG_Task,
      SELF_TEST_Task);

   type Task_Table is array (Task_Name) of Task_Attributes;

   Task_List : constant Task_Table :=
     (AD_Task        => (Report => (0, 1), Fast => (1, 3)),
      TELIN_Task     => (Report => (0, 3), Fast => (4, 1)),
      MDCIN_Task     => (Report => (1, 2), Fast => (4, 1)),
      MDCOUT_Task    => (Report => (1, 2), Fast => (1, 3)),
      LAW_Task       => (Report => (1, 2), Fast => (4, 1)),
      PWM_Task       => (Report => (2, 1), Fast => (4, 1)),
      TELOUT_Task    => (Report => (2, 3), Fast => (1, 3)),
      CORE_Task      => (Report => (4, 4), Fast => (4, 1)),
      LOG_Task       => (Report => (5, 4), Fast => (5, 2)),
      SELF_TEST_Task => (Report => (6, 1), Fast => (6, 4)));

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

   --  A cold start sets the servos to safe positions (D-13). A warm start
   --  leaves them as they are (SAF-6).

   procedure Reset_Variables;

   procedure Restart_Variables;

   --  One last downlink reports to the ground that the node stays silent
   --  (TST-4).
   procedure Report_Refused_Start;

   package Starts is new URV.Start_Routines
     (Memories, CORE_Memory, Telemetry_Board, Sealing, Errors,
      Reset_Variables, Restart_Variables, Report_Refused_Start);

   --  For the clock. Ticks is the number of ticks since the last call, at most
   --  one. Request is the length requested for the present frame (FRM-6).
   procedure Look_At_Frame
     (Ticks : Tick_Count; Request : in out Frame_Request)
   with Inline, Global => (Input => Telemetry_Board, In_Out => Frame_Lock);

   --  For the kernel: sets the time of reports, and reports an overrun.

   procedure Set_Time (Now : Clock_Tick)
   with Inline, Global => (In_Out => Errors);

   procedure Report_Overrun (Id : Task_Id)
   with Global => (In_Out => Errors);

   package Software is new URVOS.Node_Software
     (Tasks, Run_Step, Starts.Begin_Again, Set_Time, Report_Overrun,
      Look_At_Frame);

end MCS;
