--  SPDX-License-Identifier: Apache-2.0

--  The decision of the ground's TELIN task (TIN-1): its messages are
--  downlinks.

pragma SPARK_Mode;

with URV.Buffers; use URV.Buffers;
with URV.Codecs;
with URV.TELIN_Steps;

package URV.Downlink_Input is new URV.TELIN_Steps
  (Message    => Downlink_Buffer,
   Neutral    => Neutral_Downlink,
   As_Old     => Buffers.As_Old,
   Is_Old     => Buffers.Is_Old,
   Message_Of => Codecs.Downlink.Buffer_Of);
