--  SPDX-License-Identifier: Apache-2.0

--  Whether the other node is heard: blocks come that this node takes (RTP-2,
--  RTP-7). A block that was refused is not the peer's, however good its
--  checksum: it does not make the peer heard.

with Host;
with Host.Text_Numbers;
with URVOS;             use URVOS;

package Partitions.Peer_Watch is

   --  For so many frames, a second, without a good message a peer is not yet
   --  lost.
   Longest_Silence : constant :=
     Host.Microseconds_Per_Second / Host.Frame_Length;

   type Watch is limited private;

   --  The board has received so many blocks up to this frame. The node has
   --  dropped so many of them: refused, or never taken.
   procedure Look
     (This     : in out Watch;
      Received : Count;
      Dropped  : Count;
      Frame    : Host.Text_Numbers.Number);

   type Peer_State is (Never_Heard, Is_Heard, Is_Lost);

   function Present (This : Watch) return Peer_State;

   --  "never heard", "heard" or "lost".
   function Name (State : Peer_State) return String is
     (case State is
         when Never_Heard => "never heard",
         when Is_Heard    => "heard",
         when Is_Lost     => "lost");

   --  Whether exchanges are whole (RTP-4): what the other node says first in
   --  each comes in, and so does what ends it. Of the aircraft these are the
   --  uplinks, and the downlinks that it is asked for; of the ground the
   --  statuses, and the downlinks.
   type Exchange_Watch is limited private;

   --  So many beginnings and ends have come up to this frame. Is_Broken is
   --  True when for a second beginnings have come and no end.
   procedure Look
     (This      : in out Exchange_Watch;
      Begun     : Count;
      Ended     : Count;
      Frame     : Host.Text_Numbers.Number;
      Is_Broken : out Boolean;
      Changed   : out Boolean);

private

   type Exchange_Watch is limited record
      Begun     : Count   := 0;
      Ended     : Count   := 0;
      Since     : Host.Text_Numbers.Number := 0;
      Is_Broken : Boolean := False;
   end record;

   type Sighting is record
      Received : Count := 0;
      Frame    : Host.Text_Numbers.Number := 0;
   end record;

   --  The node judges a block in the frame after it came. So the blocks of
   --  two frames ago are compared with those dropped by now.
   Delay_Of_Judgement : constant := 2;

   type Sightings is array (1 .. Delay_Of_Judgement) of Sighting;

   --  Taken is the most blocks that the node is known to have taken.
   type Watch is limited record
      State    : Peer_State := Never_Heard;
      Before   : Sightings;
      Taken    : Count      := 0;
      Heard_At : Host.Text_Numbers.Number := 0;
   end record;

   function Present (This : Watch) return Peer_State is (This.State);

end Partitions.Peer_Watch;
