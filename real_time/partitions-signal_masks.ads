--  SPDX-License-Identifier: Apache-2.0

--  Blocks the partition's signals in every task except the one that waits for
--  them; and makes the operating system wake tasks as exactly as it can.
--
--  A task inherits both from the environment task, so this package is
--  elaborated before any task begins.

with Partitions.System_Calls; use Partitions.System_Calls;

package Partitions.Signal_Masks is

   pragma Elaborate_Body;

   function Ours return Signal_Set;

   --  Until the partition listens, SIGINT and SIGTERM end the program while
   --  the environment task lets them: it may wait for a file or a process.
   procedure Let_End;
   procedure Block;

end Partitions.Signal_Masks;
