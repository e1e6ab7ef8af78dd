--  SPDX-License-Identifier: Apache-2.0

with Telemetry;

package body Partitions.Flood_Guards is

   Character_Time : constant Time_Span :=
     Microseconds (Telemetry.Microseconds_Per_Character);

   --  In this time a line brings more than a burst.
   Longest_Wait : constant Time_Span := Milliseconds (100);

   procedure Start (This : out Guard; Now : Time) is
   begin
      This := (Since => Now, others => <>);
   end Start;

   procedure Take
     (This     : in out Guard;
      Now      : Time;
      Came     : Amount;
      Is_Flood : out Boolean)
   is
      Brought : Natural;
   begin
      if Now - This.Since >= Longest_Wait then
         This.Granted := Burst;
         This.Since := Now;
      elsif Now > This.Since then
         Brought := (Now - This.Since) / Character_Time;
         This.Granted :=
           Amount'Min (Burst, This.Granted + Amount (Brought));
         This.Since := This.Since + Brought * Character_Time;
      end if;

      if This.Flooded then
         This.Flooded := Came > Calm;
         Is_Flood := True;
      else
         This.Flooded := Came > This.Granted;
         Is_Flood := This.Flooded;
         This.Granted := This.Granted - Amount'Min (This.Granted, Came);
      end if;
   end Take;

end Partitions.Flood_Guards;
