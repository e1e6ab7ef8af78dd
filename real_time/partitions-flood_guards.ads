--  SPDX-License-Identifier: Apache-2.0

--  Distinguishes a flood from a line (RTP-3). A line brings a character in 96
--  us; a socket brings any amount. A guard grants the most that a line can
--  have brought, with a burst for a late machine. Any excess is discarded, and
--  the input rests for a while between two reads.

with Ada.Real_Time; use Ada.Real_Time;

package Partitions.Flood_Guards is

   --  Characters, or datagrams without characters.
   type Amount is range 0 .. 1_000_000;

   --  The possible input between two late reads: 98 ms of a line.
   Burst : constant Amount := 1_024;

   --  Between two reads in a flood.
   Rest : constant Time_Span := Milliseconds (2);

   --  At most this amount in one read ends a flood: twice that of a line.
   Calm : constant Amount := 42;

   type Guard is private;

   procedure Start (This : out Guard; Now : Time);

   --  The amount that has arrived by now. Is_Flood: it must be discarded, and
   --  the next read must wait for Rest.
   procedure Take
     (This     : in out Guard;
      Now      : Time;
      Came     : Amount;
      Is_Flood : out Boolean);

private

   type Guard is record
      Granted : Amount  := Burst;
      Since   : Time    := Time_First;
      Flooded : Boolean := False;
   end record;

end Partitions.Flood_Guards;
