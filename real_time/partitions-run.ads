--  A partition from its command line to its end (RTP-2).
--
--  While it runs it says on standard error when the other node is heard and
--  when it is lost.
--
--  Exit status: 0 run, 1 an internal fault, 2 a bad command line, input file
--  or link.

with Host.Text_Output;
with Partitions.Reports;
with Telemetry.Boards;
with URVOS;

generic
   This : Host.Node;
   with procedure Load_Script (File : String);
   with function Column_Names return String;

   --  Power up of all boards of the node.
   with procedure Switch_On;

   --  What the node has to say for the summary.
   with procedure Put_Results
     (To     : in out Host.Text_Output.Writer;
      Report : in out Reports.Report);

   --  The node's event log as JSON lines.
   with procedure Put_Events (To : in out Host.Text_Output.Writer);

   with function Overruns return URVOS.Count;

   --  What its telemetry board has counted.
   with function Link_Tally return Telemetry.Boards.Statistics;

   --  How often the node has stood still, and its telemetry board has.
   with function Pauses return URVOS.Count;
   with function Board_Starts return URVOS.Count;
procedure Partitions.Run;
