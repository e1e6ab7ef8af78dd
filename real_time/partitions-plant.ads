--  SPDX-License-Identifier: Apache-2.0

--  The JSBSim aircraft behind the boards (--plant jsbsim; GND-6): a process
--  of its own, in lock-step with the node's frames.
--
--  It is given the servos' words as the PWM task ends, flies them for a
--  frame, and is asked by the next scan, 16 ms later. The node never waits:
--  a scan for which the aircraft is not there yet has the words of the one
--  before, and the aircraft has stood still for a frame. Two such scans in a
--  row at most: then there is none, and the words are old, as they are at
--  once when the process has ended (RTP-9).
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

   --  The servos have new words, and so many messages have been received.
   procedure Fly (Servos : PWM_Buffer; Heard : Boolean);

   --  What the sensors show as a scan begins. Answers is False when the
   --  process has ended, or has not answered for more than Most_Missed scans.
   Most_Missed : constant := 2;
   procedure Look (Sensors : out Sensor_Words; Answers : out Boolean);

   --  What the newest frame that was flown shows of it, at the row's tick.
   function Truth return Shown_State;

   --  What has become of it since it was last asked, for people; nothing
   --  when all is as it was. It is now so many seconds.
   function Next_News (Now : String) return String;

   --  Why the run was no good; nothing when it was. A process that has not
   --  answered for a second is a fault, though it answers again (RTP-11).
   function Failure return String;

   --  For the summary, and the lines of --events.
   procedure Put_Counts
     (Result : in out Partitions.Reports.Report;
      To     : in out Host.Text_Output.Writer);
   procedure Put_Events (To : in out Host.Text_Output.Writer);

   --  Ends the process.
   procedure Stop;

end Partitions.Plant;
