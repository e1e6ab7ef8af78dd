--  SPDX-License-Identifier: Apache-2.0

--  Both nodes with their real wiring, between the hardware sides of their
--  boards: converters, serial line, clocks. Time passes in ticks.

with Devices.PWM_Board; use Devices.PWM_Board;
with MCS;
with Telemetry;         use Telemetry;
with URVOS;             use URVOS;
with URVOS.Frames;      use URVOS.Frames;
with URVOS.Starts;
with URVOS.Task_Trees;  use URVOS.Task_Trees;
with URV.Buffers;       use URV.Buffers;
with URV.CORE_Memory;   use URV.CORE_Memory;
with URV.Errors;        use URV.Errors;

package Node_Rig is

   --  The words of the nodes' converters
   Console : Channel_Words;
   Sensors : Channel_Words;

   --  The world outside the nodes
   Now         : Clock_Tick := 0;
   Link_Is_Cut : Boolean    := False;
   MCS_Stalls  : Boolean    := False;

   --  Cold start of both nodes and their telemetry boards, with sound
   --  memories. The console and the sensors are neutral.
   procedure Switch_On (Processors : Processor_Number := 1);

   --  A node's clock. The aircraft's is three ticks later than the ground's.
   function Clock_Of (Node : Station) return Clock_Tick;

   --  Restarts a node that was switched on, in no time. A reset also starts
   --  its telemetry board.
   procedure Start_Again
     (Node : Station; Condition : Starts.Start_Condition);

   --  One tick of both nodes, with the work of boards and line in it.
   procedure Clock_Tick_Of_Both;

   --  Character times since the last character on the line.
   Silence : Natural := 0;

   --  Runs both nodes for some major frames.
   procedure Fly (Frames : Positive);

   function CORE_Of (Node : Station) return Memory;
   function CORE_Of_MCS return Memory is (CORE_Of (Aircraft));
   function CORE_Of_GSC return Memory is (CORE_Of (Ground));
   function Log_Of (Node : Station) return Error_Log;
   function Servos return Data_Area is (MCS.PWM_Board.Contents);

   --  The servos' words at power up (SAF-1): throttle idle, brake full on,
   --  switches off, all else in the middle.
   Safe_Words : constant Data_Area :=
     (8 => 0, 9 => 16#FFF#, 14 => 0, others => 16#800#);

   --  A different number for each channel, from the first word on.
   function Numbered (First : Word) return Channel_Words;

   --  Expects these words in both CORE memories and at the servos.
   procedure Expect_Commands (What : String; First, Error : Word);
   procedure Expect_Sensors (What : String; First, Error : Word);

end Node_Rig;
