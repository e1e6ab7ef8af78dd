--  SPDX-License-Identifier: Apache-2.0

with Devices.CORE_Memory;
with GSC;
with Host;               use Host;
with Host.Stick_Scripts; use Host.Stick_Scripts;
with Partitions.Clocks;
with Partitions.Columns; use Partitions.Columns;
with Telemetry.Boards;
with URV.CORE_Layout;
with URV.Routing;

package body Partitions.Console is

   Sticks : Script;

   --  Read by the controller's tasks for the record, set by the converter.
   protected Present is
      procedure Set (Words : Console_Words);
      function Get return Console_Words;
   private
      Held : Console_Words := Neutral_Console;
   end Present;

   protected body Present is

      procedure Set (Words : Console_Words) is
      begin
         Held := Words;
      end Set;

      function Get return Console_Words is (Held);

   end Present;

   procedure Load (File : String) is
   begin
      Load (Sticks, File);
   end Load;

   procedure Sample (Words : out Channel_Words) is
      Held : Console_Words := Present.Get;
   begin
      while Next_Time (Sticks) <= Clocks.Elapsed loop
         Advance (Sticks, Held);
      end loop;
      Present.Set (Held);

      Words := (others => Neutral_Value);
      for Item in Command_Item loop
         Words (URV.Routing.Channel_Of (Item)) := Held (Item);
      end loop;
   end Sample;

   function Column_Names return String is
     (Console_Names ("console") & Uplink_Names ("gsc.uplink")
      & Downlink_Names ("gsc.downlink")
      & ",link.uplink_sent,link.uplink_scrapped,link.downlink_received"
      & ",link.downlink_bad,link.gsc_resets");

   procedure Append_Values (To : in out Row) is
      CORE  : constant Devices.CORE_Memory.Memory  :=
        GSC.CORE_Memory.Contents;
      Tally : constant Telemetry.Boards.Statistics :=
        GSC.Telemetry_Board.Tally;
   begin
      Append_Console (To, Present.Get);
      Append_Uplink (To, URV.CORE_Layout.To_Buffer (CORE.Uplink));
      Append_Downlink (To, URV.CORE_Layout.To_Buffer (CORE.Downlink));
      Append_Counts
        (To,
         (Tally.Sent, Tally.Scrapped, Tally.Received, Tally.Bad,
          Tally.Resets));
   end Append_Values;

end Partitions.Console;
