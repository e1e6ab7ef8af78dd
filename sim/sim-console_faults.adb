--  SPDX-License-Identifier: Apache-2.0

with Sim.Nodes;
with Sim.Windows;       use Sim.Windows;
with URV.Console_Watch; use URV.Console_Watch;

package body Sim.Console_Faults is

   Has_Any    : Boolean := False;
   Outages : Windows.List;
   Present : Watch;
   Is_Out  : Boolean := False;

   --  A scan had the console's words.
   Has_Come : Boolean := False;

   Current : Channel_Words := Neutral_Stick_Words;

   procedure Prepare (Script : Faults.Script) is
   begin
      Outages := Faults.Lost_Consoles (Script);
      Has_Any := Next (Outages) /= Windows.Never;
      Present := (others => <>);
      Is_Out := False;
      Has_Come := False;
      Current := Neutral_Stick_Words;
   end Prepare;

   function Are_There return Boolean is (Has_Any);

   procedure Begin_Scan (Time : Microseconds; Console : Channel_Words) is
      Longest : constant Microseconds :=
        Major_Frame * Microseconds (Frame_Count'Last);
      Silence : Microseconds;
   begin
      while Next (Outages).Stop <= Time loop
         Skip (Outages);
      end loop;
      Is_Out := Next (Outages).First <= Time;
      Silence :=
        (if not Is_Out then 0
         elsif not Has_Come then Longest
         else Microseconds'Min (Time - Next (Outages).First, Longest));
      Present := Next
        (Present, Frame_Count (Silence / Major_Frame),
         Downlink_Of (Nodes.CORE (Ground).Downlink));
      if not Is_Out then
         Has_Come := True;
         Current := Console;
      elsif Present.Input = Safe_Words then
         Current := Neutral_Stick_Words;
      end if;
   end Begin_Scan;

   procedure Keep (Which : Channel; Item : Word) is
   begin
      Current (Which) := Item;
   end Keep;

   function Brings_Scan return Boolean is (Present.Input /= Held);

   function Is_Live return Boolean is (not Is_Out);

   function Words return Channel_Words is (Current);

end Sim.Console_Faults;
