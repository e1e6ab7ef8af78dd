--  SPDX-License-Identifier: Apache-2.0

package body Telemetry.Senders with SPARK_Mode is

   procedure Send_Next
     (Item   : in out Sender;
      Data   : Block_Data;
      Length : Block_Length;
      Output : out Byte)
   is
   begin
      if Item.Sent = 0 then
         Output := Encode ((Headers.Data, Length));
         Item.Sum := Checksum.Next (Checksum.First_Value, Output);
      elsif Item.Sent <= Character_Count (Length) then
         Output := Data (Byte_Index (Item.Sent));
         Item.Sum := Checksum.Next (Item.Sum, Output);
      else
         Output := Item.Sum;
      end if;
      Item.Sent := Item.Sent + 1;

      pragma Assert
        (if Item.Sent < Message_Length (Length)
         then Item.Sum = Checksum.Of_Message
                (Encode ((Headers.Data, Length)),
                 Data,
                 Byte_Count (Item.Sent - 1)));
   end Send_Next;

end Telemetry.Senders;
