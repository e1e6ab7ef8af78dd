--  SPDX-License-Identifier: Apache-2.0

--  What the items of the buffers are called in files: the promise of the
--  stick, sensor, record and event formats.

with Devices.CORE_Memory; use Devices.CORE_Memory;
with URV.Errors;          use URV.Errors;

package Host.Names is

   function Name (Item : Uplink_Item) return String;
   function Name (Item : Downlink_Item) return String;
   function Name (Item : PWM_Item) return String;
   function Name (Item : Link_Item) return String;
   function Name (Kind : Error_Kind) return String;
   function Name (Item : Status_Item) return String;
   function Name (Which : Node) return String;

end Host.Names;
