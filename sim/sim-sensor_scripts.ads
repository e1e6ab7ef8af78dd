--  What the aircraft's sensors measure, from a file (--sensors).
--
--  The promised format allows every name of the downlink, "error" among
--  them. No sensor gives that word, the aircraft itself does: its column
--  is checked and has no effect.

with Sim.Names;
with Sim.Scripts;

package Sim.Sensor_Scripts is new Sim.Scripts
  (Item                  => Sensor_Item,
   Words                 => Sensor_Words,
   Neutral               => Neutral_Sensors,
   Name                  => Sim.Names.Name,
   Column_Without_Effect => "error");
