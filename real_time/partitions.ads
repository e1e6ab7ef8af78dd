--  The real-time partitions: one node each, in its own process, on a real
--  serial link (issue 1's and the interface's bin/urv_mcs and bin/urv_gsc).
--
--  What is here stands for the node's hardware: its serial line, its A/D
--  converter, the processor of its telemetry board, its power switch. The
--  flight software is in src and knows none of it.

package Partitions is

   pragma Pure;

end Partitions;
