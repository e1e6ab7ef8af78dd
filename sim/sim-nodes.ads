--  SPDX-License-Identifier: Apache-2.0

--  The nodes as the engine drives them: one call for either node. This package
--  handles all differences between the two (SIM-1).

with Devices.AD_Board;
with Devices.Memory_Bus;
with Telemetry;
with Telemetry.Boards;
with URV.Buffers;  use URV.Buffers;
with URV.Configurations;
with URV.CORE_Memory;
with URV.Errors;
with URV.Laws;
with URV.Link_Loss;
with URV.Seal_Blocks;
with URV.Handshakes;
with URV.Recorder_Rings;
with URV.Recorder_Rows;
with URV.Test_Runs;
with URV.Sessions;
with URVOS;        use URVOS;
with URVOS.Frame_Clocks;
with URVOS.Frame_Locks;
with URVOS.Frames;
with URVOS.Starts; use URVOS.Starts;
with URVOS.Task_Trees;

package Sim.Nodes is

   --  The number of processors of a node.
   subtype Processor_Count is URVOS.Task_Trees.Processor_Number;

   --  Before the nodes are switched on: the format of messages, the keys of
   --  format 2, which both have, and what their nonces are made of.
   procedure Seal_Link
     (Format : URV.Handshakes.Format_Number;
      Keys   : URV.Sessions.Key_List;
      Start  : URV.Seal_Blocks.Nonce);

   --  The controller starts, at power up the telemetry board too. Raised: here
   --  and below, the controller's program has raised an exception that it does
   --  not handle. The user is informed of an exception that no planted fault
   --  explains.
   procedure Start
     (Which      : Node;
      Condition  : Start_Condition;
      Now        : URVOS.Frames.Clock_Tick;
      Processors : Processor_Count;
      Raised     : out Boolean);

   --  The telemetry board's processor restarts, the controller continues.
   procedure Restart_Telemetry (Which : Node);

   procedure Clock_Interrupt
     (Which  : Node;
      Now    : URVOS.Frames.Clock_Tick;
      Raised : out Boolean);

   --  An interrupt has been handled, which a task may wait for.
   procedure Look_Again (Which : Node; Raised : out Boolean);

   --  The clock of the aircraft's PWM board ticks (SAF-11).
   procedure Tick_Servos;

   --  The analog-to-digital board's hardware: see URV.AD_Boards. It
   --  interrupts the controller if that has enabled it, and is not down.

   procedure Take_Start
     (Which   : Node;
      Wanted  : out Boolean;
      Channel : out Devices.AD_Board.Channel_Number)
   with Inline_Always;

   procedure Finish_Conversion
     (Which  : Node;
      Value  : Word;
      Is_Up  : Boolean;
      Raised : out Boolean)
   with Inline_Always;

   --  The telemetry board: see Telemetry.Shared_Boards.

   procedure Accept_Character
     (Which        : Node;
      Elapsed      : Telemetry.Character_Times;
      Data         : Byte;
      Parity_Error : Boolean;
      May_Speak    : out Boolean)
   with Inline_Always;

   procedure Next_Character
     (Which     : Node;
      Elapsed   : Telemetry.Character_Times;
      Send      : out Boolean;
      Data      : out Byte;
      Time_Left : out Telemetry.Character_Times)
   with Inline_Always;

   --  Before the nodes are switched on.
   procedure Set_Schedule (Schedule : Schedule_Name);

   --  Before the nodes are switched on: whether the aircraft's frames come
   --  in step with the ground's.
   procedure Set_Lock (On : Boolean);

   --  The same: the delay of the line, for both boards (LNK-11).
   procedure Set_Line (Item : Telemetry.Line_Delay);

   --  The requests of a node for its present frame. Its clock has ticked since
   --  the last call, or not.
   procedure Look_At_Frame
     (Which   : Node;
      Ticks   : URVOS.Frame_Clocks.Tick_Count;
      Request : in out URVOS.Frame_Clocks.Frame_Request);

   --  The aircraft's state of being in step.
   function Lock return URVOS.Frame_Locks.Lock_State;

   --  The aircraft's control laws are on or off, from the next start on.
   procedure Set_Laws (On : Boolean; By : URV.Link_Loss.Times);

   --  Before the nodes are switched on: the length of the aircraft's flight
   --  recorder.
   procedure Set_Recorder (Length : URV.Recorder_Rings.Ring_Length);

   --  The ground's console orders a block besides the sticks.
   procedure Order (Block : Uplink_Buffer);

   --  Observations of a node.

   function Servos return PWM_Buffer;

   function CORE (Which : Node) return URV.CORE_Memory.Memory;

   function Tally (Which : Node) return Telemetry.Boards.Statistics;

   function Errors (Which : Node) return URV.Errors.Error_Log;

   function Overruns (Which : Node) return Count;

   --  The memory of the aircraft's control laws, and a bit for each surface
   --  that they have detected as failed.
   function Laws return URV.Laws.Memory;
   function Failed_Surfaces return Word;

   --  The ground's settings of them.
   function Configured return URV.Configurations.Setting;

   --  The test cards aboard and their run.
   function Cards return URV.Test_Runs.Aboard;

   --  The aircraft's flight recorder, and a new block of it that has come to
   --  the ground.
   function Recorder return URV.Recorder_Rings.Ring;
   function Recorded
     (Number : URV.Recorder_Rows.Row_Number) return URV.Recorder_Rows.Row;
   procedure Take_Recorder_Block
     (Block : out Downlink_Buffer; Found : out Boolean);

   --  The processor board with the node's ROM and RAM.
   function Memory_Of (Which : Node) return Devices.Memory_Bus.Board_Number;

   --  True after an exception that no planted fault explains: a fault of the
   --  program.
   function Has_Failed return Boolean;

end Sim.Nodes;
