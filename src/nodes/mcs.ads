--  MCS: the multiprocessor control system on board the aircraft (report,
--  section 4, figure 2).
--
--  This is the wiring: the boards, the variables between the tasks, and for
--  each task which of them it consumes and produces (SET-2).

with Devices.Shared_AD_Board;
with Devices.Memory_Bus; use Devices.Memory_Bus;
with Devices.Shared_CORE_Memory;
with Devices.Shared_PWM_Board;
with Devices.Shared_RAM;
with Devices.Shared_ROM;
with Telemetry.Shared_Boards;
with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;
with URVOS.Shared_Mailboxes;
with URVOS.Start_Phases;
with URVOS.Start_Tests;
with URVOS.Starts; use URVOS.Starts;
with URVOS.Task_Trees; use URVOS.Task_Trees;
with URV.AD_Task;
with URV.ADINT_Handler;
with URV.Buffers;  use URV.Buffers;
with URV.Codecs;
with URV.CORE_Task;
with URV.Log_Senders;
with URV.LOG_Task;
with URV.Mailboxes;
with URV.MDCIN_Task;
with URV.MDCOUT_Task;
with URV.PWM_Layout;
with URV.PWM_Task;
with URV.Routing;
with URV.Self_Test_Task;
with URV.Shared_Errors;
with URV.Shared_Status;
with URV.Start_Records;
with URV.TELIN_Task;
with URV.TELOUT_Task;

package MCS with SPARK_Mode is

   --  Boards

   package AD_Board is new Devices.Shared_AD_Board;

   package PWM_Board is new Devices.Shared_PWM_Board
     (Power_Up => URV.PWM_Layout.Safe_Area);

   package CORE_Memory is new Devices.Shared_CORE_Memory;

   package Telemetry_Board is new Telemetry.Shared_Boards
     (Role            => Telemetry.Aircraft,
      Transmit_Length => URV.Codecs.Downlink.Block_Length,
      Receive_Length  => URV.Codecs.Uplink.Block_Length);

   package ROM is new Devices.Shared_ROM (Board => 2);

   package RAM is new Devices.Shared_RAM (Board => 2);

   --  Variables, each with one producer and one consumer

   package ADINT_Variable is new URVOS.Shared_Mailboxes
     (URV.Mailboxes.For_Sensor_Words);

   package AD_Variable is new URVOS.Shared_Mailboxes
     (URV.Mailboxes.For_Sensor_Images);

   package TELIN_Variable is new URVOS.Shared_Mailboxes
     (URV.Mailboxes.For_Uplink);

   package Uplink_Variable is new URVOS.Shared_Mailboxes
     (URV.Mailboxes.For_Uplink);

   package Downlink_Variable is new URVOS.Shared_Mailboxes
     (URV.Mailboxes.For_Downlink);

   package TELOUT_Variable is new URVOS.Shared_Mailboxes
     (URV.Mailboxes.For_Downlink);

   package PWM_Variable is new URVOS.Shared_Mailboxes
     (URV.Mailboxes.For_Uplink);

   package Errors is new URV.Shared_Errors;

   package Status is new URV.Shared_Status;

   --  Tasks

   package ADINT is new URV.ADINT_Handler
     (Read_Board    => AD_Board.Read,
      Start_Channel => AD_Board.Start,
      Send_ADINT    => ADINT_Variable.Send,
      Report        => Errors.Report);

   package AD is new URV.AD_Task
     (Receive_ADINT => ADINT_Variable.Receive,
      Send_AD       => AD_Variable.Send,
      Begin_Scan    => ADINT.Begin_Scan,
      Report        => Errors.Report);

   package TELIN is new URV.TELIN_Task
     (Message    => Uplink_Buffer,
      Neutral    => Neutral_Uplink,
      As_Old     => URV.Routing.As_Old,
      Decode     => URV.Codecs.Uplink.Decode,
      Take_Block => Telemetry_Board.Take,
      Send_TELIN => TELIN_Variable.Send,
      Report     => Errors.Report);

   package MDCIN is new URV.MDCIN_Task
     (Receive_TELIN => TELIN_Variable.Receive,
      Send_Uplink   => Uplink_Variable.Send,
      Send_PWM      => PWM_Variable.Send,
      Report        => Errors.Report);

   package Log_Sender is new URV.Log_Senders
     (Inspect_Log => Errors.Inspect);

   package MDCOUT is new URV.MDCOUT_Task
     (Receive_AD    => AD_Variable.Receive,
      Send_Downlink => Downlink_Variable.Send,
      Send_TELOUT   => TELOUT_Variable.Send,
      Read_Status   => Status.Read,
      Next_Piece    => Log_Sender.Next,
      Report        => Errors.Report);

   package PWM is new URV.PWM_Task
     (Receive_PWM => PWM_Variable.Receive,
      Write_Board => PWM_Board.Write,
      Report      => Errors.Report);

   package TELOUT is new URV.TELOUT_Task
     (Message        => Downlink_Buffer,
      Encode         => URV.Codecs.Downlink.Encode,
      Receive_TELOUT => TELOUT_Variable.Receive,
      Put_Block      => Telemetry_Board.Put,
      Report         => Errors.Report);

   package CORE is new URV.CORE_Task
     (Receive_Uplink   => Uplink_Variable.Receive,
      Receive_Downlink => Downlink_Variable.Receive,
      Write_Codes      => CORE_Memory.Write_Codes,
      Write_Uplink     => CORE_Memory.Write_Uplink,
      Write_Downlink   => CORE_Memory.Write_Downlink,
      Report           => Errors.Report);

   package LOG is new URV.LOG_Task
     (Inspect_Link   => Telemetry_Board.Inspect,
      Report_Several => Errors.Report_Several,
      Inspect_Log    => Errors.Inspect,
      Write_Status   => CORE_Memory.Write_Status,
      Write_Log      => CORE_Memory.Write_Log);

   --  What the check of the program memory has found (TST-3, TST-4).

   procedure Write_ROM_Result (Good_Passes, Bad_Passes : Count);

   procedure Report_ROM_Failure (Detail : Word);

   package SELF_TEST is new URV.Self_Test_Task
     (Last            => Last_ROM_Byte,
      Bytes_Per_Frame => 64,
      Read_ROM        => ROM.Read,
      Write_Result    => Write_ROM_Result,
      Report_Failure  => Report_ROM_Failure);

   --  When they run (FRM-2, SET-1). Of tasks due at the same tick the first
   --  named has the highest priority.

   type Task_Name is
     (AD_Task,
      TELIN_Task,
      MDCIN_Task,
      MDCOUT_Task,
      PWM_Task,
      TELOUT_Task,
      CORE_Task,
      LOG_Task,
      SELF_TEST_Task);

   type Offset_Table is array (Task_Name) of Minor_Frame;

   Offsets : constant Offset_Table :=
     (AD_Task        => 0,
      TELIN_Task     => 0,
      MDCIN_Task     => 1,
      MDCOUT_Task    => 1,
      PWM_Task       => 2,
      TELOUT_Task    => 2,
      CORE_Task      => 4,
      LOG_Task       => 5,
      SELF_TEST_Task => 6);

   function Id_Of (Who : Task_Name) return Task_Id is
     (Task_Name'Pos (Who) + 1)
   with Global => null;

   function Is_Task (Id : Task_Id) return Boolean is
     (Id in Id_Of (Task_Name'First) .. Id_Of (Task_Name'Last))
   with Global => null;

   function Task_Of (Id : Task_Id) return Task_Name is
     (Task_Name'Val (Id - 1))
   with
     Global => null,
     Pre    => Is_Task (Id);

   --  The header of a task that begins at once, with its initialisation.
   function Header (Who : Task_Name; Now : Clock_Tick) return Task_Header is
     ((Id               => Id_Of (Who),
       Start_Time       => Now,
       Initial_Priority => Priority'Last - Task_Name'Pos (Who)))
   with Global => null;

   --  A node of one processor or of two: the boards' tasks on the first,
   --  data collection and all that belongs to CORE on the second (KRN-5,
   --  EXT-4).
   type Processor_Number is range 1 .. 2;

   function Task_Tree_Of
     (Processors : Processor_Number;
      Which      : Processor_Number;
      Now        : Clock_Tick) return Task_Tree
   is
     (if Which > Processors then Empty_Tree
      elsif Processors = 1 then
        (1 => Header (AD_Task, Now),
           2 => Header (TELIN_Task, Now),
           3 => Header (MDCIN_Task, Now),
           4 => Header (MDCOUT_Task, Now),
           5 => Header (PWM_Task, Now),
           6 => Header (TELOUT_Task, Now),
           7 => Header (CORE_Task, Now),
           8 => Header (LOG_Task, Now),
           9 => Header (SELF_TEST_Task, Now),
           others => Null_Header)
      elsif Which = 1 then
        (1 => Header (AD_Task, Now),
           2 => Header (TELIN_Task, Now),
           3 => Header (PWM_Task, Now),
           4 => Header (TELOUT_Task, Now),
           5 => Header (SELF_TEST_Task, Now),
           others => Null_Header)
      else
        (1 => Header (MDCIN_Task, Now),
           2 => Header (MDCOUT_Task, Now),
           3 => Header (CORE_Task, Now),
           4 => Header (LOG_Task, Now),
           others => Null_Header))
   with Global => null;

   --  A task's next step: its initialisation, or the transaction of a frame.
   procedure Run_Step (Who : Task_Name; First_Run : Boolean);

   --  How the node starts (INI-1 to INI-8). The telemetry board starts by
   --  itself.

   package Start_Test is new URVOS.Start_Tests
     (Last_Byte => Last_ROM_Byte,
      Last_Word => Last_RAM_Word,
      Read_ROM  => ROM.Read,
      Read_RAM  => RAM.Read,
      Write_RAM => RAM.Write);

   package Start_Record is new URV.Start_Records
     (Inspect_CORE => CORE_Memory.Inspect,
      Write_Status => CORE_Memory.Write_Status,
      Report       => Errors.Report);

   --  The controller's routine of each start condition.

   --  Power up: servos safe (D-13), CORE and the error log cleared, nothing
   --  has been sent or received.
   procedure Cold_Start;

   --  The reset switch, or an unexpected exception: servos (SAF-6), CORE,
   --  error log and the last messages stay, all flags and counts start anew.
   procedure Warm_Start;

   --  The node stays silent after a failed self-test: one last downlink
   --  tells the ground (TST-4).
   procedure Refuse_Start;

   --  Self-test and the controller's routine; the task tree is empty after a
   --  failed self-test.
   package Start_Phases is new URVOS.Start_Phases
     (Test              => Start_Test.Run,
      Record_Start      => Start_Record.Record_Start,
      Refuse            => Refuse_Start,
      Cold_Start        => Cold_Start,
      Warm_Reset        => Warm_Start,
      Processor_Restart => Warm_Start,
      Set_Time          => Errors.Set_Time);

   procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean)
     renames Start_Phases.Run;

   --  The A/D board has converted a channel.
   procedure AD_Interrupt renames ADINT.Handle_Interrupt;

end MCS;
