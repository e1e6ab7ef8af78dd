--  The two buffers on the wire: 28 bytes up, 56 bytes down (BUF-1, BUF-2,
--  D-3, D-5).

with URV.Buffers; use URV.Buffers;
with URV.Word_Codecs;

package URV.Codecs with Pure, SPARK_Mode is

   package Uplink is new URV.Word_Codecs (Uplink_Item, Uplink_Buffer);

   package Downlink is new URV.Word_Codecs (Downlink_Item, Downlink_Buffer);

end URV.Codecs;
