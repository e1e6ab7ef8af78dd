--  SPDX-License-Identifier: Apache-2.0

--  The serial link as this machine has it: a UDP socket or a serial device.
--  There is one for each partition. What is on it: docs/real-time.md.
--
--     --link udp:HOST:PORT:PEER_HOST:PEER_PORT
--     --link serial:DEVICE

with Ada.Real_Time; use Ada.Real_Time;
with URVOS;         use URVOS;

package Partitions.Links is

   --  What a DUART has received: a character, and whether its parity bit or
   --  its frame was wrong.
   type Character_Received is record
      Data         : Byte    := 0;
      Parity_Error : Boolean := False;
   end record;

   --  More than are ever on their way.
   type Character_Count is range 0 .. 1_024;
   subtype Character_Index is Character_Count range 1 .. 1_024;

   type Received_Array is array (Character_Index) of Character_Received;

   --  How often the input was read, in a call of Receive at most.
   Most_Reads : constant := 512;
   type Read_Count is range 0 .. Most_Reads;

   --  Emptied tells that nothing more stands in the input.
   type Arrivals is record
      Reads   : Read_Count := 0;
      Length  : Character_Count := 0;
      Items   : Received_Array;
      Emptied : Boolean := False;
   end record;

   type Character_Array is array (Character_Index range <>) of Byte;

   --  Refuses what is wrong with the argument or the link: raises
   --  Host.Bad_Input.
   procedure Open (Argument : String);

   --  Returns when a character has arrived or Nudge was called, at the
   --  latest at that time. It may not look at the line.
   procedure Wait (Until_Time : Time; Look_At_Line : Boolean := True);

   procedure Nudge;

   --  Everything that has arrived, as far as there is room and it takes no
   --  more than Most_Reads.
   procedure Receive (Heard : in out Arrivals);

   --  It is not used, and counts as discarded.
   procedure Throw_Away (Heard : in out Arrivals);

   --  Throws away what stands in the input, and what comes until the line
   --  has been silent for so long: what others keep before the line comes
   --  out of there too. It gives up waiting for silence after At_Most.
   procedure Discard (Silence : Time_Span; At_Most : Time_Span);

   --  Puts the characters on the line, all together.
   procedure Send (Characters : Character_Array);

   --  Characters that the machine did not take.
   function Not_Sent return Count;

   --  Bytes that Discard has thrown away.
   function Discarded return Count;

end Partitions.Links;
