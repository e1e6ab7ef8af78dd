--  MCS: the multiprocessor control system on board the aircraft (report,
--  section 4, figure 2).
--
--  This is the wiring: the boards, the variables between the tasks, and for
--  each task which of them it consumes and produces (SET-2).

with Devices.Shared_AD_Board;
with Devices.Shared_CORE_Memory;
with Devices.Shared_PWM_Board;
with Telemetry.Shared_Boards;
with URVOS;        use URVOS;
with URVOS.Executives;
with URVOS.Frames; use URVOS.Frames;
with URVOS.Shared_Mailboxes;
with URV.AD_Task;
with URV.ADINT_Handler;
with URV.Buffers;  use URV.Buffers;
with URV.Codecs;
with URV.CORE_Task;
with URV.LOG_Task;
with URV.MDCIN_Task;
with URV.MDCOUT_Task;
with URV.PWM_Task;
with URV.Shared_Errors;
with URV.TELIN_Task;
with URV.TELOUT_Task;

package MCS with SPARK_Mode is

   --  Boards

   package AD_Board is new Devices.Shared_AD_Board;

   package PWM_Board is new Devices.Shared_PWM_Board;

   package CORE_Memory is new Devices.Shared_CORE_Memory;

   package Telemetry_Board is new Telemetry.Shared_Boards
     (Role            => Telemetry.Aircraft,
      Transmit_Length => URV.Codecs.Downlink.Block_Length,
      Receive_Length  => URV.Codecs.Uplink.Block_Length);

   --  Variables, each with one producer and one consumer

   package ADINT_Variable is new URVOS.Shared_Mailboxes
     (Channel_Words, (others => Neutral_Value));

   package AD_Variable is new URVOS.Shared_Mailboxes
     (AD_Image, Neutral_Image);

   package TELIN_Variable is new URVOS.Shared_Mailboxes
     (Uplink_Buffer, Neutral_Uplink);

   package Uplink_Variable is new URVOS.Shared_Mailboxes
     (Uplink_Buffer, Neutral_Uplink);

   package Downlink_Variable is new URVOS.Shared_Mailboxes
     (Downlink_Buffer, Neutral_Downlink);

   package TELOUT_Variable is new URVOS.Shared_Mailboxes
     (Downlink_Buffer, Neutral_Downlink);

   package PWM_Variable is new URVOS.Shared_Mailboxes
     (Uplink_Buffer, Neutral_Uplink);

   package Errors is new URV.Shared_Errors;

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
      Decode     => URV.Codecs.Uplink.Decode,
      Take_Block => Telemetry_Board.Take,
      Send_TELIN => TELIN_Variable.Send,
      Report     => Errors.Report);

   package MDCIN is new URV.MDCIN_Task
     (Receive_TELIN => TELIN_Variable.Receive,
      Send_Uplink   => Uplink_Variable.Send,
      Send_PWM      => PWM_Variable.Send,
      Report        => Errors.Report);

   package MDCOUT is new URV.MDCOUT_Task
     (Receive_AD    => AD_Variable.Receive,
      Send_Downlink => Downlink_Variable.Send,
      Send_TELOUT   => TELOUT_Variable.Send,
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
      Write_Status   => CORE_Memory.Write_Status);

   --  When they run (FRM-2, SET-1)

   type Task_Name is
     (AD_Task, TELIN_Task, MDCIN_Task, MDCOUT_Task,
      PWM_Task, TELOUT_Task, CORE_Task, LOG_Task);

   type Offset_Table is array (Task_Name) of Minor_Frame;

   Offsets : constant Offset_Table :=
     (AD_Task     => 0,
      TELIN_Task  => 0,
      MDCIN_Task  => 1,
      MDCOUT_Task => 1,
      PWM_Task    => 2,
      TELOUT_Task => 2,
      CORE_Task   => 4,
      LOG_Task    => 5);

   procedure Run_Transaction (Who : Task_Name);

   package Executive is new URVOS.Executives
     (Task_Name, Offset_Table, Offsets, Run_Transaction);

   --  Power up (INI-1, INI-3 to INI-8). The telemetry board starts by
   --  itself. The tasks begin with the next major frame.
   procedure Cold_Start (Now : Clock_Tick);

   --  The clock has ticked.
   procedure Clock_Interrupt (Now : Clock_Tick);

   --  The A/D board has converted a channel.
   procedure AD_Interrupt renames ADINT.Handle_Interrupt;

end MCS;
