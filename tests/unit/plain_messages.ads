--  SPDX-License-Identifier: Apache-2.0

--  Buffers and their blocks in message format 1.

with Telemetry;        use Telemetry;
with URV.Buffers;      use URV.Buffers;
with URV.Codecs;       use URV.Codecs;
with URV.Plain_Blocks; use URV.Plain_Blocks;

package Plain_Messages is

   function Block_Of (Source : Uplink_Buffer) return Block_Data is
     (Encode (Uplink.Words_Of (Source), Uplink.Words));

   function Block_Of (Source : Downlink_Buffer) return Block_Data is
     (Encode (Downlink.Words_Of (Source), Downlink.Words));

   function Uplink_In (Block : Block_Data) return Uplink_Buffer is
     (Uplink.Buffer_Of (Decode (Block, Uplink.Words)));

   function Downlink_In (Block : Block_Data) return Downlink_Buffer is
     (Downlink.Buffer_Of (Decode (Block, Downlink.Words)));

end Plain_Messages;
