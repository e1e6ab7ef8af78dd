--  SPDX-License-Identifier: Apache-2.0

with Ada.Characters.Handling; use Ada.Characters.Handling;

package body Host.Names is

   --  In files the error/status word has one short name.
   Error_Word : constant String := "error";

   function Name (Item : Uplink_Item) return String is
      Switch : constant String := "switch";
      Image  : constant String := To_Lower (Item'Image);
   begin
      case Item is
         when Error_Status =>
            return Error_Word;
         when Switch_Item =>
            return Switch & Image (Image'Last);
         when others =>
            return Image;
      end case;
   end Name;

   function Name (Item : Downlink_Item) return String is
     (if Item = Error_Status then Error_Word else To_Lower (Item'Image));

   function Name (Item : PWM_Item) return String is
     (To_Lower (Item'Image));

   function Name (Item : Frame_Item) return String is
     (case Item is
         when Frame_Number => "number",
         when Running_Card => "card",
         when Card_Phase   => "phase",
         when Shown_Servo  => To_Lower (Item'Image));

   function Name (Item : Link_Item) return String is
     (To_Lower (Item'Image));

   function Name (Kind : Error_Kind) return String is
     (To_Lower (Kind'Image));

   function Name (Item : Status_Item) return String is
     (To_Lower (Item'Image));

   function Label (State : Link_State) return String is
     (To_Lower (State'Image));

   function Name (Which : Node) return String is
     (case Which is
         when Ground   => "gsc",
         when Aircraft => "mcs");

end Host.Names;
