--  SPDX-License-Identifier: Apache-2.0

--  UDP sockets: the link (SAF-8), and those of the station (GND-2, GND-3). A
--  host with colons in its name is in brackets. All raise Host.Bad_Input.

with Partitions.System_Calls;

package Partitions.Sockets is

   --  A socket at the first place that sends to the second and receives only
   --  from it: Places is HOST:PORT:PEER_HOST:PEER_PORT.
   function Opened (Places : String) return System_Calls.File;

   --  A socket that sends to udp:HOST:PORT, the value of an option.
   function Sender (Option, Place : String) return System_Calls.File;

   --  A socket that receives at udp:HOST:PORT, where HOST must be a loopback
   --  address of this machine.
   function Loopback_Receiver
     (Option, Place : String) return System_Calls.File;

end Partitions.Sockets;
