with Devices.CORE_Memory;
with Devices.PWM_Board;
with Host;                use Host;
with Host.Bench;
with Host.Sensor_Scripts; use Host.Sensor_Scripts;
with MCS;
with Partitions.Clocks;
with Partitions.Columns;  use Partitions.Columns;
with Telemetry.Boards;
with URV.CORE_Layout;
with URV.PWM_Layout;
with URV.Routing;

package body Partitions.Aircraft is

   Sensors  : Script;
   Measured : Sensor_Words := Neutral_Sensors;

   function Servos return PWM_Buffer;

   function Servos return PWM_Buffer is
      Area : Devices.PWM_Board.Data_Area;
   begin
      MCS.PWM_Board.Read (Area);
      return URV.PWM_Layout.To_Outputs (Area);
   end Servos;

   procedure Load (File : String) is
   begin
      Load (Sensors, File);
   end Load;

   procedure Sample (Words : out Channel_Words) is
      Moved : Sensor_Words := Measured;
      Row   : Sensor_Words := Measured;
   begin
      Bench.Step (Servos, Moved);
      while Next_Time (Sensors) <= Clocks.Elapsed loop
         Advance (Sensors, Row);
      end loop;

      Words := (others => Neutral_Value);
      for Item in Sensor_Item loop
         Measured (Item) :=
           (if Is_Given (Sensors, Item) then Row (Item) else Moved (Item));
         Words (URV.Routing.Channel_Of (Item)) := Measured (Item);
      end loop;
   end Sample;

   function Column_Names return String is
     (Uplink_Names ("mcs.uplink") & PWM_Names ("pwm")
      & Downlink_Names ("mcs.downlink")
      & ",link.uplink_received,link.uplink_bad,link.downlink_sent"
      & ",link.downlink_scrapped,link.mcs_resets,servos_us");

   procedure Append_Values (To : in out Row) is
      CORE  : Devices.CORE_Memory.Memory;
      Tally : Telemetry.Boards.Statistics;
   begin
      MCS.CORE_Memory.Inspect (CORE);
      MCS.Telemetry_Board.Inspect (Tally);
      Append_Uplink (To, URV.CORE_Layout.To_Buffer (CORE.Uplink));
      Append_PWM (To, Servos);
      Append_Downlink (To, URV.CORE_Layout.To_Buffer (CORE.Downlink));
      Append_Counts
        (To,
         (Tally.Received, Tally.Bad, Tally.Sent, Tally.Scrapped,
          Tally.Resets));
   end Append_Values;

begin
   Bench.Start;
end Partitions.Aircraft;
