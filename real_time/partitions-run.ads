--  SPDX-License-Identifier: Apache-2.0

--  A partition from its command line to its end (RTP-2).
--
--  While it runs it says on standard error when the other node is heard and
--  when it is lost.
--
--  Exit status: 0 run, 1 an internal fault, 2 a bad command line, input file
--  or link.

with Host;
with Partitions.Nodes;

generic
   This : Host.Node;
   with package This_Node is new Partitions.Nodes (<>);
   with procedure Load_Script (File : String);
   with function Column_Names return String;
procedure Partitions.Run;
