--  SPDX-License-Identifier: Apache-2.0

--  The first byte of a message, which gives its kind (LNK-3, D-6).
--
--  The bytes are words of the extended Hamming code (8, 4): any two differ in
--  at least four bits, and each has an even number of ones. Therefore up to
--  three wrong bits in a character, including its parity bit, never turn one
--  header into another.

package Telemetry.Headers with Pure, SPARK_Mode is

   type Header_Kind is (Command_To_Downlink, Status, Data);

   --  The block lengths that have a header. The header of a data message
   --  replaces its byte count.
   subtype Block_Length is Byte_Count
   with
     Static_Predicate =>
       Block_Length in 1 | 2 | 4 | Uplink_Length | Downlink_Length;

   type Header (Kind : Header_Kind := Command_To_Downlink) is record
      case Kind is
         when Command_To_Downlink =>
            null;
         when Status =>
            --  The last data message was received with a good checksum.
            Good : Boolean;

            --  The sender has data to downlink (aircraft only).
            Wants_Downlink : Boolean;
         when Data =>
            Length : Block_Length;
      end case;
   end record
   with Alignment => 2;

   --  The other six code words (00, 66, 78, AA, E1 and FF, hexadecimal) have
   --  no meaning. Blocks of 1, 2 and 4 bytes serve to test the whole protocol
   --  with short messages.

   function Is_Valid (Value : Byte) return Boolean is
     (Value in 16#1E# | 16#2D# | 16#33# | 16#4B# | 16#55#
             | 16#87# | 16#99# | 16#B4# | 16#CC# | 16#D2#)
   with Global => null;

   function Encode (Item : Header) return Byte is
     (case Item.Kind is
         when Command_To_Downlink => 16#4B#,
         when Status              =>
           (if Item.Good
            then (if Item.Wants_Downlink then 16#2D# else 16#D2#)
            else (if Item.Wants_Downlink then 16#33# else 16#CC#)),
         when Data                =>
           (case Item.Length is
               when Uplink_Length   => 16#1E#,
               when Downlink_Length => 16#87#,
               when 1               => 16#55#,
               when 2               => 16#99#,
               when 4               => 16#B4#))
   with
     Global => null,
     Post   => Is_Valid (Encode'Result);

   function Decode (Value : Byte) return Header is
     (case Value is
         when 16#4B# => (Kind => Command_To_Downlink),
         when 16#2D# => (Status, Good => True,  Wants_Downlink => True),
         when 16#D2# => (Status, Good => True,  Wants_Downlink => False),
         when 16#33# => (Status, Good => False, Wants_Downlink => True),
         when 16#CC# => (Status, Good => False, Wants_Downlink => False),
         when 16#1E# => (Data, Length => Uplink_Length),
         when 16#87# => (Data, Length => Downlink_Length),
         when 16#55# => (Data, Length => 1),
         when 16#99# => (Data, Length => 2),
         when others => (Data, Length => 4))
   with
     Global => null,
     Pre    => Is_Valid (Value),
     Post   => Encode (Decode'Result) = Value;

   --  The parts of a decoded header: a copy of one takes longer on a small
   --  processor.

   function Kind_Of (Value : Byte) return Header_Kind is
     (case Value is
         when 16#4B#                            => Command_To_Downlink,
         when 16#2D# | 16#D2# | 16#33# | 16#CC# => Status,
         when others                            => Data)
   with
     Global => null,
     Pre    => Is_Valid (Value),
     Post   => Kind_Of'Result = Decode (Value).Kind;

   function Is_Good (Value : Byte) return Boolean is
     (Value in 16#2D# | 16#D2#)
   with
     Global => null,
     Pre    => Is_Valid (Value) and then Kind_Of (Value) = Status,
     Post   => Is_Good'Result = Decode (Value).Good;

   function Wants_Downlink (Value : Byte) return Boolean is
     (Value in 16#2D# | 16#33#)
   with
     Global => null,
     Pre    => Is_Valid (Value) and then Kind_Of (Value) = Status,
     Post   => Wants_Downlink'Result = Decode (Value).Wants_Downlink;

   --  A decoded header is the one that was encoded.
   procedure Round_Trip (Item : Header)
   with
     Ghost,
     Global => null,
     Post   => Decode (Encode (Item)) = Item;

end Telemetry.Headers;
