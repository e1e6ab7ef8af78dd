--  SPDX-License-Identifier: Apache-2.0

--  The plant at the aircraft's boards: surfaces that follow the servos with a
--  lag and constant other sensors, any of them replaced from a file
--  (--sensors); or an aircraft in JSBSim (--plant jsbsim; GND-6).

with Host.Options;
with Host.Text_Output;
with MCS;
with Partitions.Reports;
with Partitions.Rows; use Partitions.Rows;
with URV.Buffers;     use URV.Buffers;

package Partitions.Aircraft is

   --  Raises Host.Bad_Input.
   procedure Prepare (Chosen : Host.Options.Choices);

   --  The words at the A/D board's channels. Called once for each scan: the
   --  surfaces have then moved for a major frame. A dead plant gives no
   --  answer.
   procedure Sample
     (Is_Next  : Boolean;
      Words    : out Channel_Words;
      Is_There : out Boolean);

   --  The names and the values of this node's columns of the record.
   function Column_Names return String;
   procedure Append_Values (To : in out Row);

   --  With the control laws, their status (EXT-3), under the names of the
   --  simulation's record.
   function Last_Names return String;
   procedure Append_Laws (To : in out Row);

   --  The rows of the flight recorder (FTI-11).
   procedure Put_Recording (To : in out Host.Text_Output.Writer);

   --  See Partitions.Run: the plant, and the frames in step (FRM-6).
   function Next_Message (Now : String) return String;
   procedure Put_Counts
     (Result : in out Partitions.Reports.Report;
      To     : in out Host.Text_Output.Writer);

   --  A task's transaction is over.
   procedure Observe (Who : MCS.Task_Name);

end Partitions.Aircraft;
