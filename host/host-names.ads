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

   --  Of the words of the laws' row (URV.Law_Status); empty for the one that
   --  is none.
   function Law_Word_Name (Which : Log_Field) return String is
     (case Which is
         when Occurrences_High => "modes",
         when Occurrences_Low  => "invalid_low",
         when First_Frame_High => "invalid_high",
         when First_Frame_Low  => "silent",
         when Last_Frame_High  => "failed",
         when Last_Frame_Low   => "",
         when Last_Detail      => "configuration");

end Host.Names;
