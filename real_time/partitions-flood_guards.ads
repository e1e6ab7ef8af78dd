--  SPDX-License-Identifier: Apache-2.0

--  Tells a flood from a line (RTP-3). A line brings a character in 96 us; a
--  socket brings whatever anyone sends to it. A guard grants as much as a
--  line can have brought, with a burst of what a late machine may find, and
--  no more: what exceeds that is thrown away, and the input rests for a while
--  between two looks.

with Ada.Real_Time; use Ada.Real_Time;

package Partitions.Flood_Guards is

   --  Characters, or datagrams if they have none.
   type Amount is range 0 .. 1_000_000;

   --  What may have come while nobody looked: 98 ms of a line.
   Burst : constant Amount := 1_024;

   --  Between two looks in a flood.
   Rest : constant Time_Span := Milliseconds (2);

   --  In a flood so much in a look is a line again: twice what one brings.
   Calm : constant Amount := 42;

   type Guard is private;

   procedure Start (This : out Guard; Now : Time);

   --  So much has come by now. Is_Flood tells that it is to be thrown away,
   --  and that the next look is to wait for Rest.
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
