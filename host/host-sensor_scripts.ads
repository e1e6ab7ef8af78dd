--  SPDX-License-Identifier: Apache-2.0

--  What the aircraft's sensors measure, from a file (--sensors).
--
--  The promised format allows every name of the downlink, "error" among
--  them. No sensor gives that word, the aircraft itself does: its column
--  is checked and has no effect.

with Host.Names;
with Host.Scripts;

package Host.Sensor_Scripts is new Host.Scripts
  (Item                  => Sensor_Item,
   Words                 => Sensor_Words,
   Neutral               => Neutral_Sensors,
   Name                  => Host.Names.Name,
   Column_Without_Effect => "error");
