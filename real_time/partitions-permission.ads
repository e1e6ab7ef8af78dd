--  SPDX-License-Identifier: Apache-2.0

--  Ends a program whose tasks would never begin, and says why (RTP-2).
--
--  As root the run-time system of GNAT gives tasks and locks priorities
--  without looking whether it may. In a container it may not, unless that
--  was asked for: the first task that begins is lost, and the program waits
--  for it for ever. Other users without the right do without priorities: a
--  loaded machine then delays the node, and the link loses messages (RTP-8).
--
--  It is elaborated before any task begins.

package Partitions.Permission is

   pragma Elaborate_Body;

   --  Whether this program may give its tasks their priorities.
   function Is_Granted return Boolean;

   --  The consequence, and the command that grants the right, for people.
   function How_To_Grant return String is
     ("no real-time priorities: on a loaded machine the link loses messages;"
      & " grant them in this shell with: sudo prlimit --pid $$ --rtprio=99");

end Partitions.Permission;
