--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Peer_Watch is

   use type Number;

   procedure Look
     (This     : in out Watch;
      Received : Count;
      Frame    : Number;
      Change   : out News) is
   begin
      Change := Nothing_New;
      if Received /= This.Former then
         Change := (if This.Now = Is_Heard then Nothing_New else Heard);
         This.Now := Is_Heard;
         This.Former := Received;
         This.Heard_At := Frame;
      elsif This.Now = Is_Heard
        and then Frame > This.Heard_At + Longest_Silence
      then
         Change := Lost;
         This.Now := Is_Lost;
      end if;
   end Look;

   function State (This : Watch) return String is
     (case This.Now is
         when Never_Heard => "never heard",
         when Is_Heard    => "heard",
         when Is_Lost     => "lost");

end Partitions.Peer_Watch;
