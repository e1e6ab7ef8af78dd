--  SPDX-License-Identifier: Apache-2.0

--  The transmitting half of the board's software, for one block: header,
--  data, checksum, character by character (report, appendix A.3;
--  LNK-3).

with Telemetry.Checksum;
with Telemetry.Headers; use Telemetry.Headers;
with Telemetry.Memory;  use Telemetry.Memory;

package Telemetry.Senders with Pure, SPARK_Mode is

   --  Characters of a message: header, data, checksum.
   type Character_Count is range 0 .. Longest_Block + 2;

   type Sender is record
      Source : Slot            := First;
      Sent   : Character_Count := 0;

      --  The checksum of the characters sent so far.
      Sum    : Byte            := 0;
   end record;

   function Message_Length (Length : Block_Length) return Character_Count is
     (Character_Count (Length) + 2)
   with Global => null;

   --  What stands at a place of the message, from 1.
   function Message_Byte
     (Data   : Block_Data;
      Length : Block_Length;
      Place  : Character_Count) return Byte
   is
     (if Place = 1
      then Encode ((Headers.Data, Length))
      elsif Place <= Character_Count (Length) + 1
      then Data (Byte_Index (Place - 1))
      else Checksum.Of_Message
             (Encode ((Headers.Data, Length)), Data, Length))
   with
     Ghost,
     Global => null,
     Pre    => Place in 1 .. Message_Length (Length);

   --  The message is not finished, and the checksum is that of its part
   --  already sent.
   function Fits
     (Item   : Sender;
      Data   : Block_Data;
      Length : Block_Length) return Boolean
   is
     (Item.Sent < Message_Length (Length)
      and then
        (if Item.Sent > 0
         then Item.Sum = Checksum.Of_Message
                (Encode ((Headers.Data, Length)),
                 Data,
                 Byte_Count (Item.Sent - 1))))
   with Global => null;

   --  The sender after one more character: it sums up the header and the
   --  data as they go.
   function Advanced
     (Item   : Sender;
      Data   : Block_Data;
      Length : Block_Length) return Sender
   is
     ((Item with delta
         Sent => Item.Sent + 1,
         Sum  =>
           (if Item.Sent <= Character_Count (Length)
            then Checksum.Of_Message
                   (Encode ((Headers.Data, Length)),
                    Data,
                    Byte_Count (Item.Sent))
            else Item.Sum)))
   with
     Ghost,
     Global => null,
     Pre    => Item.Sent < Message_Length (Length);

   --  The next character of the message.
   procedure Send_Next
     (Item   : in out Sender;
      Data   : Block_Data;
      Length : Block_Length;
      Output : out Byte)
   with
     Global => null,
     Pre    => Fits (Item, Data, Length),
     Post   =>
       Item = Advanced (Item'Old, Data, Length)
       and then Output = Message_Byte (Data, Length, Item.Sent)
       and then
         (if Item.Sent < Message_Length (Length)
          then Fits (Item, Data, Length));

end Telemetry.Senders;
