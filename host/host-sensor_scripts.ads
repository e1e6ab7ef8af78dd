--  SPDX-License-Identifier: Apache-2.0

--  The measurements of the aircraft's sensors, from a file (--sensors).
--
--  The promised format allows every name of the downlink, "error" among them.
--  The aircraft itself makes this word, not a sensor: its column is checked
--  and has no effect.

with Host.Names;
with Host.Scripts;

package Host.Sensor_Scripts is new Host.Scripts
  (Item                  => Sensor_Item,
   Words                 => Sensor_Words,
   Neutral               => Neutral_Sensors,
   Name                  => Host.Names.Name,
   Column_Without_Effect => "error");
