--  SPDX-License-Identifier: Apache-2.0

--  A node in its partition: the flight software's tasks, and the hardware of
--  its boards (RTP-1).

with Devices.Memory_Bus;
with Devices.Shared_AD_Board;
with Partitions.Measurements; use Partitions.Measurements;
with Partitions.Peer_Watch;   use Partitions.Peer_Watch;
with Partitions.Rows;         use Partitions.Rows;
with Telemetry.Boards;
with Telemetry.Shared_Boards;
with URVOS;                   use URVOS;
with URVOS.Frame_Clocks;      use URVOS.Frame_Clocks;
with URVOS.Frames;            use URVOS.Frames;
with URVOS.Kernel_Calls;      use URVOS.Kernel_Calls;
with URVOS.Starts;            use URVOS.Starts;
with URVOS.Task_Lists;
with URVOS.Task_Trees;        use URVOS.Task_Trees;
with URVOS.Usual_Frames;
with URV.Buffers;             use URV.Buffers;
with URV.Errors;
with URV.Seal_Blocks;
with URV.Handshakes;
with URV.Sessions;
with URV.Shared_Errors;
with URV.Shared_Schedules;
with URV.Shared_Seals;

generic
   --  The node: see URVOS.Real_Time_Nodes.

   with package Tasks is new URVOS.Task_Lists (<>);
   with procedure Run_Step
     (Who       : Tasks.Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);
   with procedure Begin_Again
     (Condition : Start_Condition;
      Now       : Clock_Tick;
      Passed    : out Boolean);
   with procedure Tell_Time (Now : Clock_Tick);
   with procedure Report_Overrun (Who : Task_Id);
   with procedure Look_At_Frame
     (Ticks   : Tick_Count;
      Request : out Frame_Request)
   is URVOS.Usual_Frames;

   --  Its boards.

   AD_Board        : in out Devices.Shared_AD_Board.Board;
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   Errors          : in out URV.Shared_Errors.Shared_Log;
   Sealing         : in out URV.Shared_Seals.Shared_Seal;
   Schedule        : in out URV.Shared_Schedules.Store;
   Processor_Board : Devices.Memory_Bus.Board_Number;
   with procedure Handle_AD_Interrupt;

   --  The first begins scans; after the others the telemetry board has new
   --  data, and the frame's words are in CORE.
   AD_Task     : Tasks.Task_Name;
   TELOUT_Task : Tasks.Task_Name;
   CORE_Task   : Tasks.Task_Name;

   --  Samples the converter's channels (see Partitions.Converter), and appends
   --  to a row of the record.
   with procedure Sample
     (Is_Next  : Boolean;
      Words    : out Channel_Words;
      Is_There : out Boolean);
   with procedure Append_Values (To : in out Row);

   --  Appends the last columns of a row.
   with procedure Append_Last (To : in out Row) is null;

   --  The row has been taken.
   with procedure Publish (Item : Row) is null;

   --  Another transaction is over.
   with procedure Observe (Who : Tasks.Task_Name) is null;
package Partitions.Nodes is

   --  The duration of each task's transactions, and their ends after the tick
   --  of their minor frame; in tenths of microseconds.
   type Distributions is array (Tasks.Task_Name) of Distribution;

   Costs     : Distributions;
   Responses : Distributions;

   --  The delay of the clock's ticks, in tenths of microseconds.
   Lateness : Distribution;

   --  Before it is switched on: see URV.Shared_Seals.
   procedure Seal_Link
     (Format : URV.Handshakes.Format_Number;
      Keys   : URV.Sessions.Key_List;
      Start  : URV.Seal_Blocks.Nonce);

   --  Power up of every board.
   procedure Switch_On
     (Processors : Processor_Number;
      Chosen     : Schedule_Name := Report;
      Line       : Telemetry.Line_Delay := 0);

   function Overruns return Count;

   --  The counts of the telemetry board.
   function Link_Tally return Telemetry.Boards.Statistics is
     (Telemetry_Board.Tally);

   --  The state of the other node, by the newest frame's row.
   function Peer return Peer_State;

   --  Blocks that were not the peer's (SEC-5).
   function Refused return Count;

   --  The number of pauses that the node has detected.
   function Pauses return Count;

   --  The number of pauses that the telemetry board's processor has detected.
   function Board_Starts return Count;

   function Log return URV.Errors.Error_Log is (Errors.Contents);

end Partitions.Nodes;
