--  SPDX-License-Identifier: Apache-2.0

--  UDP sockets: the link (SAF-8), and those of the station (GND-2, GND-3).
--  A host that has colons in its name is in brackets. All raise
--  Host.Bad_Input.

with Partitions.System_Calls;

package Partitions.Sockets is

   --  A socket at the first place, that speaks to the second and hears
   --  nobody else: Places is HOST:PORT:PEER_HOST:PEER_PORT.
   function Opened (Places : String) return System_Calls.File;

   --  A socket that sends to udp:HOST:PORT, which an option names.
   function Sender (Option, Place : String) return System_Calls.File;

   --  A socket that hears what is sent to udp:HOST:PORT, and HOST is this
   --  machine's loopback.
   function Loopback_Receiver
     (Option, Place : String) return System_Calls.File;

end Partitions.Sockets;
