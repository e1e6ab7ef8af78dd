--  SPDX-License-Identifier: Apache-2.0

--  The serial link on this machine: a UDP socket or a serial device. There is
--  one for each partition. Its contents are in docs/real-time.md.
--
--     --link udp:HOST:PORT:PEER_HOST:PEER_PORT
--     --link serial:DEVICE

with Ada.Real_Time; use Ada.Real_Time;
with URVOS;         use URVOS;

package Partitions.Links is

   --  A character from the DUART's receiver, and whether its parity bit or its
   --  frame was wrong.
   type Character_Received is record
      Data         : Byte    := 0;
      Parity_Error : Boolean := False;
   end record;

   --  More than are ever in transit.
   type Character_Count is range 0 .. 1_024;
   subtype Character_Index is Character_Count range 1 .. 1_024;

   type Received_Array is array (Character_Index) of Character_Received;

   --  The largest number of reads in a call of Receive.
   Most_Reads : constant := 512;
   type Read_Count is range 0 .. Most_Reads;

   --  Emptied: the input is empty.
   type Arrivals is record
      Reads   : Read_Count := 0;
      Length  : Character_Count := 0;
      Items   : Received_Array;
      Emptied : Boolean := False;
   end record;

   type Character_Array is array (Character_Index range <>) of Byte;

   --  Refuses errors in the argument or the link: raises Host.Bad_Input.
   procedure Open (Argument : String);

   --  Returns when a character has arrived or Wake was called, at the latest
   --  at that time. Without Look_At_Line it ignores the line.
   procedure Wait (Until_Time : Time; Look_At_Line : Boolean := True);

   procedure Wake;

   --  Takes the arrived characters, as long as there is room and at most
   --  Most_Reads reads.
   procedure Receive (Heard : in out Arrivals);

   --  The result is unused, and counts as discarded.
   procedure Throw_Away (Heard : in out Arrivals);

   --  Discards the input, and all that arrives until the line has been silent
   --  for Silence: this includes characters that the system buffered before
   --  the line. It waits for silence until At_Most.
   procedure Discard (Silence : Time_Span; At_Most : Time_Span);

   --  Puts the characters on the line, all together.
   procedure Send (Characters : Character_Array);

   --  Characters that the machine did not accept.
   function Not_Sent return Count;

   --  Bytes discarded by Discard.
   function Discarded return Count;

end Partitions.Links;
