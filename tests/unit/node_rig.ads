--  SPDX-License-Identifier: Apache-2.0

--  Both nodes as they are wired, between the hardware's sides of their
--  boards: converters, serial line, clocks. Time goes by in ticks.

with Devices.CORE_Memory; use Devices.CORE_Memory;
with Devices.PWM_Board;   use Devices.PWM_Board;
with MCS;
with Telemetry;           use Telemetry;
with URVOS;               use URVOS;
with URVOS.Frames;        use URVOS.Frames;
with URVOS.Starts;
with URVOS.Task_Trees;    use URVOS.Task_Trees;
with URV.Buffers;         use URV.Buffers;
with URV.Errors;          use URV.Errors;

package Node_Rig is

   --  What the converters of the nodes see.
   Console : Channel_Words;
   Sensors : Channel_Words;

   --  The world outside the nodes.
   Now         : Clock_Tick := 0;
   Link_Is_Cut : Boolean    := False;
   MCS_Stalls  : Boolean    := False;

   --  Cold start of both nodes and their telemetry boards, with sound
   --  memories. The console and the sensors are neutral.
   procedure Switch_On (Processors : Processor_Number := 1);

   --  A node's clock: the aircraft's is three ticks behind the ground's.
   function Clock_Of (Node : Station) return Clock_Tick;

   --  A node that has been switched on starts again, in no time. A reset
   --  starts its telemetry board, too.
   procedure Start_Again
     (Node : Station; Condition : Starts.Start_Condition);

   --  One tick of both nodes, and what the boards and the line do in it.
   procedure Clock_Tick_Of_Both;

   --  Character times since the last character on the line.
   Silence : Natural := 0;

   --  Both nodes for some major frames.
   procedure Fly (Frames : Positive);

   function CORE_Of (Node : Station) return Memory;
   function CORE_Of_MCS return Memory is (CORE_Of (Aircraft));
   function CORE_Of_GSC return Memory is (CORE_Of (Ground));
   function Log_Of (Node : Station) return Error_Log;
   function Servos return Data_Area is (MCS.PWM_Board.Contents);

   --  What the servos hold at power up (SAF-1): throttle idle, brake full
   --  on, switches off, all else in the middle.
   Safe_Words : constant Data_Area :=
     (8 => 0, 9 => 16#FFF#, 14 => 0, others => 16#800#);

   --  A number for each channel: the first word and on.
   function Numbered (First : Word) return Channel_Words;

   --  Words as they stand in both CORE memories and at the servos.
   procedure Expect_Commands (What : String; First, Error : Word);
   procedure Expect_Sensors (What : String; First, Error : Word);

end Node_Rig;
