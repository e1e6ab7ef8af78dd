--  SPDX-License-Identifier: Apache-2.0

--  Where a console of another process sends its packets (--console; GND-3,
--  GND-4).
--
--  Whoever can send here flies, so the port is one of the machine's
--  loopback. What cannot be taken is dropped and counted.

with Ada.Real_Time; use Ada.Real_Time;

with Host;  use Host;
with Partitions.Octets;
with URVOS; use URVOS;

package Partitions.Console_Port is

   --  A console that has been silent for so long keeps the sticks no more.
   Longest_Silence : constant Time_Span := Milliseconds (500);

   --  A packet that was made longer ago than this has waited somewhere. One of
   --  the future has no known age, and is dropped as well.
   Longest_Way : constant Host.Microseconds := 500_000;

   --  What the port has of the console.
   --  Has_Come: a packet has been taken. Silence: how old the last one is.
   type Situation is record
      Has_Come    : Boolean       := False;
      Silence     : Time_Span     := Time_Span_Last;
      Words       : Console_Words := Neutral_Console;
      Sequence    : Octets.Number := 0;
      Pilot_Flies : Boolean       := False;
   end record;

   --  Listens at udp:HOST:PORT. Raises Host.Bad_Input.
   procedure Open (Place : String);

   function Is_Open return Boolean;

   --  How things stand at that time. Where no packet has come yet the
   --  simulated pilot flies, if there is one.
   function Seen (At_Time : Time) return Situation;

   --  How many packets were taken, and how many datagrams were not.
   function Taken return Count;
   function Dropped return Count;

end Partitions.Console_Port;
