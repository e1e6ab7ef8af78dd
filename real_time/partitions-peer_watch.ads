--  SPDX-License-Identifier: Apache-2.0

--  Watches the other node. It is heard while this node takes its blocks
--  (RTP-2, RTP-7). A refused block is not the peer's, even with a valid
--  checksum.

with Host;
with Host.Text_Numbers;
with URVOS;             use URVOS;

package Partitions.Peer_Watch is

   --  The number of frames without a good message, one second, after which a
   --  peer is lost.
   Longest_Silence : constant :=
     Host.Microseconds_Per_Second / Host.Frame_Length;

   type Watch is limited private;

   --  The number of blocks that the board has received up to this frame, and
   --  the number that the node has dropped: refused, or never taken.
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

   --  An exchange is whole (RTP-4) if its first and its last message arrive
   --  from the other node: in the aircraft the uplink and the request for a
   --  downlink, on the ground the status and the downlink.
   type Exchange_Watch is limited private;

   --  The numbers of beginnings and ends up to this frame. Is_Broken is True
   --  when for a second there were beginnings and no end.
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

   --  The node judges a block in the frame after its arrival. The blocks of
   --  two frames ago are therefore compared with those dropped by now.
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
