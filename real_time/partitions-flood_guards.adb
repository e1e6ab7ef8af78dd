--  SPDX-License-Identifier: Apache-2.0

with Telemetry;

package body Partitions.Flood_Guards is

   Character_Time : constant Time_Span :=
     Microseconds (Telemetry.Microseconds_Per_Character);

   --  Longer than that a line brings more than a burst anyway.
   Longest_Wait : constant Time_Span := Milliseconds (100);

   procedure Start (Item : out Guard; Now : Time) is
   begin
      Item := (Since => Now, others => <>);
   end Start;

   procedure Take
     (Item     : in out Guard;
      Now      : Time;
      Came     : Amount;
      Is_Flood : out Boolean)
   is
      Brought : Natural;
   begin
      if Now - Item.Since >= Longest_Wait then
         Item.Granted := Burst;
         Item.Since := Now;
      elsif Now > Item.Since then
         Brought := (Now - Item.Since) / Character_Time;
         Item.Granted :=
           Amount'Min (Burst, Item.Granted + Amount (Brought));
         Item.Since := Item.Since + Brought * Character_Time;
      end if;

      if Item.Flooded then
         Item.Flooded := Came > Calm;
         Is_Flood := True;
      else
         Item.Flooded := Came > Item.Granted;
         Is_Flood := Item.Flooded;
         Item.Granted := Item.Granted - Amount'Min (Item.Granted, Came);
      end if;
   end Take;

end Partitions.Flood_Guards;
