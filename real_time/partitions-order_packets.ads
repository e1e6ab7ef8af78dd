--  SPDX-License-Identifier: Apache-2.0

--  The order packet: what the station orders besides the sticks, in one
--  datagram (GND-35). docs/station-packets.md has its layout.

with Partitions.Octets;  use Partitions.Octets;
with URV.Configurations; use URV.Configurations;

package Partitions.Order_Packets is

   Length : constant := 34;

   --  A configuration is all that there is to be ordered. Whether its values
   --  may be is the aircraft's affair.
   type Packet is record
      Run      : Number        := 0;
      Sequence : Number        := 0;
      Made_At  : Number        := 0;   --  UTC, us since 1970
      Item     : Configuration := (others => 0);
   end record;

   --  Whether it begins as one.
   function Is_Meant (Source : Octet_Array) return Boolean;

   --  Any bytes at all. What is no order packet is not valid.
   procedure Read
     (Source   : Octet_Array;
      Item     : out Packet;
      Is_Valid : out Boolean);

end Partitions.Order_Packets;
