--  SPDX-License-Identifier: Apache-2.0

--  Ends a program whose tasks would never begin, and reports the reason
--  (RTP-2).
--
--  As root the run-time system of GNAT gives tasks and locks priorities
--  without checking its rights. A container without the right denies this: the
--  first task is lost, and the program waits for it for ever. Other users
--  without the right run without priorities: a loaded machine then delays the
--  node, and the link loses messages (RTP-8).
--
--  It is elaborated before any task begins.

package Partitions.Permission is

   pragma Elaborate_Body;

   --  True if this program may give its tasks their priorities.
   function Is_Granted return Boolean;

   --  The consequence, and the command that grants the right, for people.
   function How_To_Grant return String is
     ("no real-time priorities: on a loaded machine the link loses messages;"
      & " grant them in this shell with: sudo prlimit --pid $$ --rtprio=99");

end Partitions.Permission;
