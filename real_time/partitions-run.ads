--  SPDX-License-Identifier: Apache-2.0

--  A partition from its command line to its end (RTP-2).
--
--  During the run it reports on standard error when the other node is heard
--  and when it is lost.
--
--  Exit status: 0 run, 1 an internal fault, a dead plant or a lost output, 2 a
--  bad command line, input file or link, 3 run, but the other node was never
--  heard.

with Host;
with Host.Options;
with Host.Text_Output;
with Partitions.Nodes;
with Partitions.Reports;

generic
   This : Host.Node;
   with package This_Node is new Partitions.Nodes (<>);

   --  Opens the files and links of the command line. Raises Host.Bad_Input.
   with procedure Prepare (Chosen : Host.Options.Choices);
   with function Column_Names return String;
   with function Last_Names return String;

   --  Rows have an aircraft's truth.
   with function Has_Truth return Boolean;

   --  News of the node's environment, for people, or empty. Now is the present
   --  time in seconds.
   with function Next_News (Now : String) return String;

   --  For the summary and the events.
   with procedure Put_Counts
     (Result : in out Reports.Report;
      To     : in out Host.Text_Output.Writer);
   with procedure Put_Events (To : in out Host.Text_Output.Writer);

   --  The reason of a failed run; empty after a good one.
   with function Failure return String;

   --  The last call of a run.
   with procedure Stop is null;
procedure Partitions.Run;
