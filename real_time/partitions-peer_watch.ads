--  SPDX-License-Identifier: Apache-2.0

--  Whether the other node is heard: good messages of it come in (RTP-2).

with Host;
with Partitions.Rows; use Partitions.Rows;
with URVOS;           use URVOS;

package Partitions.Peer_Watch is

   --  For so many frames, a second, without a good message a peer is not yet
   --  lost.
   Longest_Silence : constant :=
     Host.Microseconds_Per_Second / Host.Frame_Length;

   type Watch is limited private;

   type News is (Nothing_New, Heard, Lost);

   --  So many good messages have come up to this frame.
   procedure Look
     (This     : in out Watch;
      Received : Count;
      Frame    : Number;
      Change   : out News);

   type Peer_State is (Never_Heard, Is_Heard, Is_Lost);

   function Present (This : Watch) return Peer_State;

   --  "never heard", "heard" or "lost".
   function State (This : Watch) return String;

private

   type Watch is limited record
      Now      : Peer_State := Never_Heard;
      Former   : Count      := 0;
      Heard_At : Number     := 0;
   end record;

   function Present (This : Watch) return Peer_State is (This.Now);

end Partitions.Peer_Watch;
