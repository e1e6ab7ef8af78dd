--  SPDX-License-Identifier: Apache-2.0

--  The transmitting half of the board's software, for one block: header, data
--  and checksum, character by character (report, appendix A.3; LNK-3). The
--  board assigns the results of these functions.

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
   end record
   with Alignment => 2;

   function Message_Length (Length : Block_Length) return Character_Count is
     (Character_Count (Length) + 2)
   with Global => null;

   --  The message is not finished, and Sum is the checksum of the part already
   --  sent.
   function Fits
     (This   : Sender;
      Data   : Block_Data;
      Length : Block_Length) return Boolean
   is
     (This.Sent < Message_Length (Length)
      and then
        (if This.Sent > 0
         then This.Sum = Checksum.Of_Message
                (Encode ((Headers.Data, Length)),
                 Data,
                 Byte_Count (This.Sent - 1))))
   with Global => null;

   --  The next character of the message: the header, the data, and last the
   --  checksum of both.
   function Next_Byte
     (This   : Sender;
      Data   : Block_Data;
      Length : Block_Length) return Byte
   is
     (if This.Sent = 0
      then Encode ((Headers.Data, Length))
      elsif This.Sent <= Character_Count (Length)
      then Data (Byte_Index (This.Sent))
      else This.Sum)
   with
     Global => null,
     Pre    => Fits (This, Data, Length),
     Post   =>
       (if This.Sent > Character_Count (Length)
        then Next_Byte'Result = Checksum.Of_Message
          (Encode ((Headers.Data, Length)), Data, Length));

   --  The sender after that character. It adds the header and the data to the
   --  checksum as they are sent.
   function Advanced
     (This   : Sender;
      Data   : Block_Data;
      Length : Block_Length) return Sender
   is
     ((This with delta
         Sent => This.Sent + 1,
         Sum  =>
           (if This.Sent <= Character_Count (Length)
            then Checksum.Next
              ((if This.Sent = 0 then Checksum.First_Value else This.Sum),
               Next_Byte (This, Data, Length))
            else This.Sum)))
   with
     Global => null,
     Pre    => Fits (This, Data, Length),
     Post   =>
       (if This.Sent = 0
        then Advanced'Result.Sum = Checksum.Of_Message
          (Encode ((Headers.Data, Length)), Data, 0)
        elsif This.Sent <= Character_Count (Length)
        then Advanced'Result.Sum = Checksum.Of_Message
          (Encode ((Headers.Data, Length)), Data, Byte_Count (This.Sent)));

end Telemetry.Senders;
