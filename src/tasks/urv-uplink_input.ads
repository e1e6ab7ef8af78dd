--  SPDX-License-Identifier: Apache-2.0

--  The decision of the aircraft's TELIN task (TIN-1): its messages are
--  uplinks.

pragma SPARK_Mode;

with URV.Buffers; use URV.Buffers;
with URV.Codecs;
with URV.TELIN_Steps;

package URV.Uplink_Input is new URV.TELIN_Steps
  (Message    => Uplink_Buffer,
   Neutral    => Neutral_Uplink,
   As_Old     => Buffers.As_Old,
   Is_Old     => Buffers.Is_Old,
   Message_Of => Codecs.Uplink.Buffer_Of);
