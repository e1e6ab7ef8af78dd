--  SPDX-License-Identifier: Apache-2.0

--  The console packet: the pilot's sticks and switches in one datagram
--  (GND-3). Its layout is in docs/station-packets.md.

with Host; use Host;
with Partitions.Octets; use Partitions.Octets;

package Partitions.Console_Packets is

   Length : constant := 52;

   type Packet is record
      Run         : Number        := 0;
      Sequence    : Number        := 0;
      Made_At     : Number        := 0;   --  UTC, us since 1970
      Words       : Console_Words := Neutral_Console;
      Pilot_Flies : Boolean       := False;
   end record;

   --  Accepts any bytes. A datagram of another kind is not valid.
   procedure Read
     (Source   : Octet_Array;
      Item     : out Packet;
      Is_Valid : out Boolean);

end Partitions.Console_Packets;
