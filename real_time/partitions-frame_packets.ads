--  SPDX-License-Identifier: Apache-2.0

--  The frame packet: the contents of GSC CORE at the end of a major frame, in
--  one datagram (GND-2, GND-7). Its layout is in docs/station-packets.md.

with Host.Frame_Layout; use Host.Frame_Layout;
with Partitions.Octets; use Partitions.Octets;
with URV.Buffers;       use URV.Buffers;
with URV.CORE_Memory;   use URV.CORE_Memory;

package Partitions.Frame_Packets is

   --  Large enough for each version.
   subtype Packet is Octet_Array (1 .. Longest);

   --  The age of a downlink before the first one.
   Never : constant := 16#FFFF_FFFF#;

   type Link_Counts is array (Link_Count) of Number;

   --  The words of console, uplink and downlink, as in the record.
   type Word_List is array (1 .. Word_Count) of Number;

   type Frame is record
      Run              : Number;
      Sequence         : Number;
      Time             : Number;
      Downlink_Age     : Number;
      Console_State    : Number;
      Link_State       : Number;
      Console_Sequence : Number;
      Counts           : Link_Counts;
      Words            : Word_List;
      Log              : Log_Rows;
      Aircraft_Log     : Log_Rows;
      Status           : Status_Words;
      Pilot            : Number;
      Downlink_Frame   : Frame_Words;
   end record;

   --  The bytes after its length are 0.
   function To_Packet
     (Item : Frame; Version : Version_Number) return Packet;

end Partitions.Frame_Packets;
