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
with Partitions.Nodes;
with Partitions.Row_Contents;
with Partitions.Surroundings;

generic
   This : Host.Node;
   with package This_Node is new Partitions.Nodes (<>);

   --  Opens the files and links of the command line. Raises Host.Bad_Input.
   with package Contents is new Partitions.Row_Contents (<>);
   with package Surroundings is new Partitions.Surroundings (<>);
procedure Partitions.Run;
