--  SPDX-License-Identifier: Apache-2.0

--  A UDP socket as the link (SAF-8).

with Partitions.System_Calls;

package Partitions.Sockets is

   --  A socket at the first place, that speaks to the second and hears
   --  nobody else: Places is HOST:PORT:PEER_HOST:PEER_PORT, a host that has
   --  colons in its name is in brackets. Raises Host.Bad_Input.
   function Opened (Places : String) return System_Calls.File;

end Partitions.Sockets;
