--  SPDX-License-Identifier: Apache-2.0

--  The port for packets of a console in another process (--console; GND-3,
--  GND-4).
--
--  Any sender to this port can fly, so it is on one of the machine's loopback
--  addresses. Invalid datagrams are dropped and counted.

with Ada.Real_Time; use Ada.Real_Time;

with Host;  use Host;
with Partitions.Octets;
with URVOS; use URVOS;

package Partitions.Console_Port is

   --  A console that is silent for longer loses the sticks.
   Longest_Silence : constant Time_Span := Milliseconds (500);

   --  An older packet has waited somewhere. One of the future has no known
   --  age, and is dropped as well.
   Longest_Delay : constant Host.Microseconds := 500_000;

   --  The state of the console.
   --  Has_Come: a packet has been taken. Silence: the age of the last one.
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

   --  The state at that time. Before the first packet the simulated pilot
   --  flies, if there is one.
   function Seen (At_Time : Time) return Situation;

   --  The numbers of packets taken and of datagrams dropped.
   function Taken return Count;
   function Dropped return Count;

end Partitions.Console_Port;
