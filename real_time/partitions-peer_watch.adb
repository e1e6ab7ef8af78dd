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

   procedure Look
     (This      : in out Exchange_Watch;
      Begun     : Count;
      Ended     : Count;
      Frame     : Host.Text_Numbers.Number;
      Is_Broken : out Boolean;
      Changed   : out Boolean)
   is
      Was : constant Boolean := This.Is_Broken;
   begin
      if Ended /= This.Ended then
         This.Is_Broken := False;
         This.Begun := Begun;
         This.Ended := Ended;
         This.Since := Frame;
      elsif Frame >= This.Since + Longest_Silence then
         --  Half a second of them is enough.
         This.Is_Broken := This.Is_Broken
           or else Begun - This.Begun >= Longest_Silence / 2;
         This.Begun := Begun;
         This.Since := Frame;
      end if;
      Is_Broken := This.Is_Broken;
      Changed := This.Is_Broken /= Was;
   end Look;

end Partitions.Peer_Watch;
