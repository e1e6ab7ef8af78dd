--  SPDX-License-Identifier: Apache-2.0

--  The two buffers on the wire, each as long as a block (BUF-1, BUF-2, D-3,
--  D-5).

with Telemetry;
with URV.Buffers; use URV.Buffers;
with URV.Word_Codecs;

package URV.Codecs with Pure, SPARK_Mode is

   package Uplink is new URV.Word_Codecs (Uplink_Item, Uplink_Buffer);

   package Downlink is new URV.Word_Codecs (Downlink_Item, Downlink_Buffer);

   pragma Compile_Time_Error
     (2 * (Uplink_Item'Pos (Uplink_Item'Last) + 1)
        /= Telemetry.Uplink_Length,
      "Telemetry.Uplink_Length must be twice the words of an uplink buffer");

   pragma Compile_Time_Error
     (2 * (Downlink_Item'Pos (Downlink_Item'Last) + 1)
        /= Telemetry.Downlink_Length,
      "Telemetry.Downlink_Length must be twice a downlink buffer's words");

end URV.Codecs;
