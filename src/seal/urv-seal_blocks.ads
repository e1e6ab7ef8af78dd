--  SPDX-License-Identifier: Apache-2.0

--  Message format 2: the bytes of a block (SEC-1). A block is as long as in
--  format 1.
--
--                  uplink        downlink
--     mark         byte 1        byte 1        high half; low half: flags
--     fields       bytes 2..22   bytes 2..43   of 12 bits, two in three bytes
--     card         none          byte 45       the fourth before the tag
--     number       last field    bytes 46..48  the three before the tag
--     echo         last field    byte 44       the byte before the card
--     tag          bytes 23..28  bytes 49..56  the last
--
--  The fields are the block's words except the last, the error/status word.
--  Its four flags are in byte 1. The log's fragment above them is the last
--  field of a downlink (D-15). A command beyond 12 bits is sent as 0FFFh, the
--  value that would reach a servo (D-11).
--
--  The receiver makes a downlink's spare bits of its number and card (D-98).
--
--  The number is the session's frame in which the sender sealed the block. The
--  echo is the number of the newest block that the sender had taken by then.
--  An uplink carries 6 bits of each; the tag covers both in full (SEC-4).
--
--  A hello has another mark; its bytes are a key's number and two nonces. In
--  format 1 the high half of the first byte is 0, unless a converter gives
--  more than 12 bits.

with Interfaces;       use Interfaces;
with Telemetry;        use Telemetry;
with URVOS;            use URVOS;
with URV.Plain_Blocks; use URV.Plain_Blocks;
with URV.Sip_Hash;     use URV.Sip_Hash;
with URV.Spare_Bits;   use URV.Spare_Bits;

package URV.Seal_Blocks with Pure, SPARK_Mode is

   Sealed_Mark : constant Byte := 16#A0#;
   Hello_Mark  : constant Byte := 16#B0#;

   function Mark_Of (Block : Block_Data) return Byte is
     (Block (1) and 16#F0#)
   with Global => null;

   --  The ground sends uplinks, the aircraft downlinks.

   Uplink_Words   : constant := Uplink_Length / 2;
   Downlink_Words : constant := Downlink_Length / 2;

   subtype Word_Total is Word_Place range Uplink_Words .. Downlink_Words;

   function Words_Of (Sender : Station) return Word_Total is
     (if Sender = Ground then Uplink_Words else Downlink_Words)
   with Global => null;

   Uplink_Tag   : constant := 6;
   Downlink_Tag : constant := 8;

   subtype Tag_Length is Byte_Count range Uplink_Tag .. Downlink_Tag;

   function Tag_Bytes (Sender : Station) return Tag_Length is
     (if Sender = Ground then Uplink_Tag else Downlink_Tag)
   with Global => null;

   --  The bytes that the tag covers.
   Uplink_Covered   : constant := Uplink_Length - Uplink_Tag;
   Downlink_Covered : constant := Downlink_Length - Downlink_Tag;

   function Covered (Sender : Station) return Byte_Index is
     (if Sender = Ground then Uplink_Covered else Downlink_Covered)
   with Global => null;

   --  The byte before a downlink's card and number. It holds the echo.
   Before_Counter : constant := Downlink_Covered - 4;

   --  Each further word needs a byte and a half and may not fit
   pragma Compile_Time_Error
     (1 + (3 * Uplink_Words + 1) / 2 > Uplink_Covered,
      "in format 2 the fields of an uplink reach into its tag");

   pragma Compile_Time_Error
     (1 + (3 * Downlink_Words + 1) / 2 >= Before_Counter,
      "in format 2 the fields of a downlink reach into its echo");

   pragma Compile_Time_Error
     (Downlink_Covered + 8 > Message_Index'Last,
      "in format 2 a downlink exceeds URV.Sip_Hash.Message");

   --  The frames of a session: the numbers of blocks; 0 means none.
   type Counter is range 0 .. 2 ** 31 - 1;

   subtype Field is Word range 0 .. 16#FFF#;

   --  The running card and its phase in one byte.
   function Card_Of (Data : Block_Words) return Byte is
     (Byte (Spare_Of (Data (Card_Place))) * 16
      + Byte (Spare_Of (Data (Phase_Place))))
   with
     Global => null,
     Post   =>
       Middle (Word (Card_Of'Result)) = Spare_Of (Data (Card_Place))
       and then
         Low (Word (Card_Of'Result)) = Spare_Of (Data (Phase_Place));

   --  The last field of an uplink: the number's remainder and the echo's code.
   --  The code is also a remainder, or No_Echo

   Number_Modulus : constant := 2 ** 6;
   Echo_Modulus   : constant := 2 ** 6 - 1;
   No_Echo        : constant := Echo_Modulus;

   subtype Echo_Code is Word range 0 .. No_Echo;

   function Code_Of (Echo : Counter) return Echo_Code is
     (if Echo = 0 then No_Echo else Word (Echo mod Echo_Modulus))
   with Global => null;

   function Field_Of
     (Data   : Block_Words;
      Sender : Station;
      Number : Counter;
      Echo   : Counter;
      Which  : Word_Place) return Field
   is
     (if Which < Words_Of (Sender)
      then (if Sender = Ground then Clipped (Data (Which))
            else Without_Spare (Data (Which)))
      elsif Sender = Ground
      then Word (Number mod Number_Modulus) * Number_Modulus + Code_Of (Echo)
      else Data (Which) / 16)
   with
     Global => null,
     Pre    => Which <= Words_Of (Sender);

   --  The value of a field. The first of a pair takes one byte and the high
   --  half of the next, the second takes the low half and one more byte.
   function Field_At (Block : Block_Data; Which : Word_Place) return Field is
     (if Which mod 2 = 1
      then Word (Block (3 * (Which / 2) + 2)) * 16
           + Word (Block (3 * (Which / 2) + 3)) / 16
      else Word (Block (3 * (Which / 2)) mod 16) * 256
           + Word (Block (3 * (Which / 2) + 1)))
   with Global => null;

   function Byte_Of (Number : Counter; Where : Byte_Index) return Byte is
     (case Where is
         when 1      => Byte (Number / 2 ** 24),
         when 2      => Byte (Number / 2 ** 16 mod 256),
         when 3      => Byte (Number / 2 ** 8 mod 256),
         when others => Byte (Number mod 256))
   with
     Global => null,
     Pre    => Where <= 4;

   --  A downlink's number.
   function Number_At (Block : Block_Data) return Counter is
     (Counter (Block (Before_Counter + 2)) * 2 ** 16
      + Counter (Block (Before_Counter + 3)) * 2 ** 8
      + Counter (Block (Before_Counter + 4)))
   with Global => null;

   --  The echo's code.
   function Code_At (Block : Block_Data; Sender : Station) return Word is
     (if Sender = Ground
      then Field_At (Block, Uplink_Words) mod Number_Modulus
      else Word (Block (Before_Counter)))
   with Global => null;

   --  The bytes of the words, without a tag.
   function Packed
     (Data   : Block_Words;
      Sender : Station;
      Number : Counter;
      Echo   : Counter) return Block_Data
   with
     Global => null,
     Post   =>
       Packed'Result (1) =
         (Sealed_Mark or Byte (Data (Words_Of (Sender)) mod 16))
       and then
         (for all Which in Word_Place =>
            (if Which <= Words_Of (Sender)
             then Field_At (Packed'Result, Which) =
                    Field_Of (Data, Sender, Number, Echo, Which)))
       and then
         (if Sender = Aircraft
          then Packed'Result (Before_Counter) = Byte (Code_Of (Echo))
            and then Packed'Result (Before_Counter + 1) = Card_Of (Data)
            and then
            (for all Where in Byte_Index range 2 .. 4 =>
               Packed'Result (Before_Counter + Where) =
                 Byte_Of (Number, Where)));

   --  The spare bits of a downlink's word in format 1.
   function Spare_In_Format_2 (Block : Block_Data; Which : Word_Place)
                               return Nibble
   is
     (Sealed_With
        (Number => Word (Block (Before_Counter + 3)) * 256
                     + Word (Block (Before_Counter + 4)),
         Card   => Word (Block (Before_Counter + 1)),
         Place  => Positive (Which)))
   with Global => null;

   --  A word of a block in format 2.
   function Word_In_Format_2
     (Block  : Block_Data;
      Sender : Station;
      Which  : Word_Place) return Word
   is
     (if Which < Words_Of (Sender)
      then
        (if Sender = Ground then Field_At (Block, Which)
         else Field_At (Block, Which)
           or Spare_In_Format_2 (Block, Which) * Spare_Unit)
      elsif Sender = Ground then Word (Block (1) and 16#0F#)
      else Field_At (Block, Which) * 16 + Word (Block (1) and 16#0F#))
   with
     Global => null,
     Pre    => Which <= Words_Of (Sender);

   --  The words of a block in format 2.
   function Unpacked
     (Block  : Block_Data;
      Sender : Station) return Block_Words
   with
     Global => null,
     Post   =>
       (for all Which in Word_Place =>
          Unpacked'Result (Which) =
            (if Which <= Words_Of (Sender)
             then Word_In_Format_2 (Block, Sender, Which)
             else 0));

   --  Nonces: each node starts with one and advances it with each session. The
   --  high byte comes first.
   type Nonce is new Unsigned_64;

   function Byte_Of (Item : Nonce; Where : Byte_Index) return Byte is
     (Byte (Shift_Right (Unsigned_64 (Item), 8 * (8 - Integer (Where)))
            and 16#FF#))
   with
     Global => null,
     Pre    => Where <= 8;

   function Nonce_At (Block : Block_Data; First : Byte_Index) return Nonce is
     (Nonce
        (Shift_Left (Unsigned_64 (Block (First)), 56)
         or Shift_Left (Unsigned_64 (Block (First + 1)), 48)
         or Shift_Left (Unsigned_64 (Block (First + 2)), 40)
         or Shift_Left (Unsigned_64 (Block (First + 3)), 32)
         or Shift_Left (Unsigned_64 (Block (First + 4)), 24)
         or Shift_Left (Unsigned_64 (Block (First + 5)), 16)
         or Shift_Left (Unsigned_64 (Block (First + 6)), 8)
         or Unsigned_64 (Block (First + 7))))
   with
     Global => null,
     Pre    => First <= Byte_Index'Last - 7;

   --  A hello without its tag: the sender's nonce, and the other node's nonce
   --  that it answers, or 0. An uplink answers none

   type Key_Number is range 0 .. 255;

   Own_Place      : constant Byte_Index := 3;
   Answered_Place : constant Byte_Index := 11;

   function Hello
     (Number   : Key_Number;
      Own      : Nonce;
      Answered : Nonce) return Block_Data
   with
     Global => null,
     Post   =>
       (for all Where in Byte_Index =>
          Hello'Result (Where) =
            (if Where = 1 then Hello_Mark
             elsif Where = 2 then Byte (Number)
             elsif Where in 3 .. 10 then Byte_Of (Own, Where - 2)
             elsif Where in 11 .. 18 then Byte_Of (Answered, Where - 10)
             else 0));

   --  The message under the tag: the full number and echo of the block, and
   --  the bytes before the tag. An uplink carries only the remainders of both
   --  numbers.
   function Message_Of
     (Block  : Block_Data;
      Sender : Station;
      Number : Counter;
      Echo   : Counter) return Message
   is
     ((Length => Message_Length (Covered (Sender)) + 8,
       Bytes  =>
         [for Where in Message_Index =>
            (if Where <= 4 then Byte_Of (Number, Byte_Index (Where))
             elsif Where <= 8 then Byte_Of (Echo, Byte_Index (Where - 4))
             elsif Where <= Message_Length (Covered (Sender)) + 8
             then Block (Byte_Index (Where - 8))
             else 0)]))
   with Ghost, Global => null;

   --  The block's bytes are hashed in place.
   function Tag_Of
     (Block    : Block_Data;
      Sender   : Station;
      Number   : Counter;
      Echo     : Counter;
      With_Key : Key) return Unsigned_64
   with
     Global => null,
     Post   =>
       Tag_Of'Result =
         Reference (Message_Of (Block, Sender, Number, Echo), With_Key);

   --  A byte of the tag, the low byte first. An uplink has the first six.
   function Tag_Byte (Item : Unsigned_64; Where : Byte_Index) return Byte is
     (Byte (Shift_Right (Item, 8 * (Integer (Where) - 1)) and 16#FF#))
   with
     Global => null,
     Pre    => Where <= Tag_Length'Last;

   function Has_Tag
     (Block  : Block_Data;
      Sender : Station;
      Item   : Unsigned_64) return Boolean
   with
     Global => null,
     Post   =>
       Has_Tag'Result =
         (for all Where in Byte_Index =>
            (if Where <= Tag_Bytes (Sender)
             then Block (Covered (Sender) + Where) =
                    Tag_Byte (Item, Where)));

   function With_Tag
     (Block  : Block_Data;
      Sender : Station;
      Item   : Unsigned_64) return Block_Data
   is
     ([for Where in Byte_Index =>
         (if Where > Covered (Sender)
            and then Where <= Covered (Sender) + Tag_Bytes (Sender)
          then Tag_Byte (Item, Where - Covered (Sender))
          else Block (Where))])
   with
     Global => null,
     Post   => Has_Tag (With_Tag'Result, Sender, Item);

end URV.Seal_Blocks;
