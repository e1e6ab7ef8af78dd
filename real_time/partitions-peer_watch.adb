--  SPDX-License-Identifier: Apache-2.0

package body Partitions.Peer_Watch is

   use type Host.Text_Numbers.Number;

   procedure Look
     (This     : in out Watch;
      Received : Count;
      Dropped  : Count;
      Frame    : Host.Text_Numbers.Number)
   is
      Judged : constant Sighting := This.Before (1);
      Taken  : constant Count    := Count'Max (Judged.Received - Dropped, 0);
   begin
      This.Before :=
        (This.Before (2 .. Delay_Of_Judgement) & Sighting'(Received, Frame));
      if Taken > This.Taken then
         This.State := Is_Heard;
         This.Taken := Taken;
         This.Heard_At := Judged.Frame;
      elsif This.State = Is_Heard
        and then Frame > This.Heard_At + Longest_Silence
      then
         This.State := Is_Lost;
      end if;
   end Look;

end Partitions.Peer_Watch;
