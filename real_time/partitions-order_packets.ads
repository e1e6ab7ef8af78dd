--  SPDX-License-Identifier: Apache-2.0

--  The order packet: the station's orders besides the sticks, in one datagram
--  (GND-35, FTI-8, FTI-10). Its layout is in docs/station-packets.md.

with Partitions.Octets; use Partitions.Octets;
with URV.Buffers;       use URV.Buffers;

package Partitions.Order_Packets is

   --  The bytes of an order: a configuration; or a test card, or a request for
   --  rows of the flight recorder.
   Configuration_Length : constant := 34;
   Card_Length          : constant := 50;

   --  Block: as it goes up. The aircraft checks its values.
   type Packet is record
      Run      : Number        := 0;
      Sequence : Number        := 0;
      Made_At  : Number        := 0;   --  UTC, us since 1970
      Block    : Uplink_Buffer := Neutral_Uplink;
   end record;

   --  True if the datagram begins as an order packet.
   function Is_Meant (Source : Octet_Array) return Boolean;

   --  Accepts any bytes. A datagram of another kind is not valid.
   procedure Read
     (Source   : Octet_Array;
      Item     : out Packet;
      Is_Valid : out Boolean);

end Partitions.Order_Packets;
