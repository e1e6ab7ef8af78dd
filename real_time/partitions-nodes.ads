--  SPDX-License-Identifier: Apache-2.0

--  A node in its partition: the flight software's tasks, and the hardware of
--  its boards (RTP-1).

with Partitions.Boards;
with Partitions.Measurements; use Partitions.Measurements;
with Partitions.Peer_Watch;   use Partitions.Peer_Watch;
with Partitions.Row_Contents;
with Telemetry.Boards;
with URVOS;                   use URVOS;
with URVOS.Node_Software;
with URVOS.Task_Trees;        use URVOS.Task_Trees;
with URV.Buffers;             use URV.Buffers;
with URV.Errors;
with URV.Seal_Blocks;
with URV.Handshakes;
with URV.Sessions;

generic
   with package Software is new URVOS.Node_Software (<>);
   with package Boards is new Partitions.Boards (<>);
   with package Contents is new Partitions.Row_Contents (<>);

   --  The first begins scans. After the second the telemetry board has new
   --  data, and after the third CORE has the frame's words.
   AD_Task     : Software.Tasks.Task_Name;
   TELOUT_Task : Software.Tasks.Task_Name;
   CORE_Task   : Software.Tasks.Task_Name;

   --  Samples the converter's channels (see Partitions.Converter).
   with procedure Sample
     (Is_Next  : Boolean;
      Words    : out Channel_Words;
      Is_There : out Boolean);

   --  A transaction of another task is over.
   with procedure Observe (Who : Software.Tasks.Task_Name) is null;
package Partitions.Nodes is

   --  The duration of each task's transactions, and their ends after the tick
   --  of their minor frame; in tenths of microseconds.
   type Distributions is array (Software.Tasks.Task_Name) of Distribution;

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
     (Boards.Telemetry_Board.Tally);

   --  The state of the other node, by the newest frame's row.
   function Peer return Peer_State;

   --  Blocks that were not the peer's (SEC-5).
   function Refused return Count;

   --  The number of pauses that the node has detected.
   function Pauses return Count;

   --  The number of pauses that the telemetry board's processor has detected.
   function Board_Starts return Count;

   function Log return URV.Errors.Error_Log is (Boards.Errors.Contents);

end Partitions.Nodes;
