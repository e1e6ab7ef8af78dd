--  SPDX-License-Identifier: Apache-2.0

--  The real-time partitions bin/urv_mcs and bin/urv_gsc: one node each, in
--  its own process, on a real byte stream (RTP-1).
--
--  What is here stands for the node's hardware: its serial line, its A/D
--  converter, the processor of its telemetry board, its power switch. The
--  flight software is in src and knows none of it.

package Partitions is

   pragma Pure;

end Partitions;
