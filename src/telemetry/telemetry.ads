--  SPDX-License-Identifier: Apache-2.0

--  The telemetry board's software (report, appendix A).
--
--  This package defines the bytes of a block, the unit of the board's timer,
--  the two stations, and the board's counts.

with URVOS;        use URVOS;
with URVOS.Frames; use URVOS.Frames;

package Telemetry with Pure, SPARK_Mode is

   --  The ground's board is bus master; the aircraft's board answers (LNK-2).
   type Station is (Ground, Aircraft);

   --  The bytes of a block's data, without header and checksum: two for each
   --  word of the buffer (D-3, D-5). URV.Codecs does not compile if they
   --  differ.
   Uplink_Length   : constant := 28;
   Downlink_Length : constant := 56;
   Longest_Block   : constant := Downlink_Length;

   type Byte_Count is range 0 .. Longest_Block;
   subtype Byte_Index is Byte_Count range 1 .. Longest_Block;

   type Byte_Array is array (Byte_Index range <>) of Byte
   with Alignment => 2;

   --  Room for the longest block.
   subtype Block_Data is Byte_Array (Byte_Index);

   --  The board's timer counts character times. At 125 kbaud a character
   --  of start, 8 data, parity and 2 stop bits takes 96 us (D-4).
   Microseconds_Per_Character : constant := 96;

   type Character_Times is range 0 .. 1_000;

   --  The wait of a board at the end of a data message. It is longer than one
   --  character, so a message with an extra character is bad (LNK-5, D-27).
   Guard_Time : constant Character_Times := 2;

   --  The characters that fit in a major frame, and those of an exchange
   --  without faults: both data messages with header, checksum and guard time,
   --  both answers and the command (LNK-2, FRM-1).
   Room_In_Frame : constant :=
     Ticks_Per_Major_Frame * Microseconds_Per_Tick
     / Microseconds_Per_Character;
   Exchange      : constant :=
     Uplink_Length + Downlink_Length + 2 * (2 + Guard_Time) + 3;

   --  The silence after which the ground starts again, also after each
   --  exchange (D-28). It is shorter if the frame is shorter. The dead space,
   --  a board's wait for the other board, is shorter than the idle time
   --  (LNK-9).
   Idle_Time  : constant Character_Times :=
     Character_Times'Min (24, Room_In_Frame - Exchange - 1);
   Dead_Space : constant Character_Times := Idle_Time * 5 / 6;

   --  For a line slower than a wire (LNK-11), an answer comes later by its
   --  round trip. Both boards then wait longer by that time. An exchange has
   --  two round trips and the idle time one, so a frame must have room for
   --  three. D-38 gives the reasons.
   Longest_Round_Trip : constant :=
     (Room_In_Frame - Exchange - 1 - Idle_Time) / 3;
   type Round_Trip_Time is range 0 .. Longest_Round_Trip;

   function Dead_Space_On (Line : Round_Trip_Time) return Character_Times is
     (Dead_Space + Character_Times (Line))
   with Global => null;

   function Idle_Time_On (Line : Round_Trip_Time) return Character_Times is
     (Idle_Time + Character_Times (Line))
   with Global => null;

   --  The longest time of a character from one board to the other, in
   --  microseconds, after its last bit has left: 0 to 1,392.
   subtype Line_Delay is Integer range
     0 .. Longest_Round_Trip * Microseconds_Per_Character / 2;

   function Round_Trip_Of (Line : Line_Delay) return Round_Trip_Time is
     (Round_Trip_Time
        ((2 * Line + Microseconds_Per_Character - 1)
         / Microseconds_Per_Character))
   with Global => null;

   pragma Compile_Time_Error
     (Dead_Space < 5,
      "a major frame has no room for an exchange and the ground's idle time");

   type Statistics is record
      Sent      : Count := 0;   --  data messages, retries included
      Received  : Count := 0;   --  data messages with a good checksum
      Bad       : Count := 0;   --  data messages that were bad or cut short
      Scrapped  : Count := 0;   --  blocks given up after two transmissions
      Cleared   : Count := 0;   --  blocks cleared for a newer one
      Resets    : Count := 0;   --  dead space resets

      --  Blocks received that the controller had not taken when the next one
      --  came. They are lost: of two full buffers the controller gets the
      --  newer.
      Not_Taken : Count := 0;
   end record;

   --  Value, incremented if the condition holds.
   function Counted (Value : Count; If_So : Boolean) return Count is
     (if If_So then Incremented (Value) else Value)
   with Global => null;

end Telemetry;
