--  SPDX-License-Identifier: Apache-2.0

--  The real-time partitions bin/urv_mcs and bin/urv_gsc: one node each, in its
--  own process, on a real byte stream (RTP-1).
--
--  These packages replace the node's hardware: its serial line, its A/D
--  converter, the processor of its telemetry board, its power switch. The
--  flight software in src is independent of them.

package Partitions is

   pragma Pure;

end Partitions;
