--  SPDX-License-Identifier: Apache-2.0

--  Ends a program whose tasks would never begin, and says why (RTP-2).
--
--  As root the run-time system of GNAT gives tasks and locks priorities
--  without looking whether it may. In a container it may not, unless that
--  was asked for: the first task that begins is lost, and the program waits
--  for it for ever. Whoever is not root does without priorities.
--
--  It is elaborated before any task begins.

package Partitions.Permission is

   pragma Elaborate_Body;

end Partitions.Permission;
