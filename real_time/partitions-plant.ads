--  SPDX-License-Identifier: Apache-2.0

--  The JSBSim aircraft of the boards (--plant jsbsim; GND-6): a process of its
--  own, in lock-step with the node's frames.
--
--  It receives the servos' words as the PWM task ends, flies them for a frame,
--  and answers at the next scan, 16 ms later. The node never waits: a scan
--  before the aircraft's answer has the words of the one before, and the
--  aircraft was stopped for a frame. After two such scans in a row there is no
--  scan, and the words are old; after the process has ended this happens at
--  once (RTP-9).
--
--  It waits in level flight until the node has heard the ground.

with Host;                use Host;
with Host.Plant_Messages; use Host.Plant_Messages;
with Host.Text_Output;
with Partitions.Reports;
with URV.Buffers;         use URV.Buffers;

package Partitions.Plant is

   --  Starts the process, whose aircraft is settled then. Raises
   --  Host.Bad_Input.
   procedure Start (Schedule : Schedule_Name);

   function Is_Present return Boolean;

   --  The servos have new words; Heard: messages have been received.
   procedure Fly (Servos : PWM_Buffer; Heard : Boolean);

   --  The sensors' words as a scan begins. Answers is False when the process
   --  has ended, or has not answered for more than Most_Missed scans.
   Most_Missed : constant := 2;
   procedure Look (Sensors : out Sensor_Words; Answers : out Boolean);

   --  The state in the newest flown frame, at the row's tick.
   function Truth return Shown_State;

   --  Changes since the last call, for people; empty when there are none. Now
   --  is the present time in seconds.
   function Next_Message (Now : String) return String;

   --  The reason of a failed run; empty after a good one. A process that has
   --  not answered for a second is a fault, even if it answers again (RTP-11).
   function Failure return String;

   --  For the summary, and the lines of --events.
   procedure Put_Counts
     (Result : in out Partitions.Reports.Report;
      To     : in out Host.Text_Output.Writer);
   procedure Put_Events (To : in out Host.Text_Output.Writer);

   --  Ends the process.
   procedure Stop;

end Partitions.Plant;
