--  SPDX-License-Identifier: Apache-2.0

--  The names of the buffers' items in files: the promise of the stick, sensor,
--  record and event formats.

with URV.CORE_Memory; use URV.CORE_Memory;
with URV.Errors;      use URV.Errors;
with URV.Law_Status;
with URV.Laws;        use URV.Laws;
with URV.Link_Loss;   use URV.Link_Loss;

package Host.Names is

   function Name (Item : Uplink_Item) return String;
   function Name (Item : Downlink_Item) return String;
   function Name (Item : PWM_Item) return String;

   --  In files "number", "card", "phase", and the servos (FTI-12).
   function Name (Item : Frame_Item) return String;
   function Name (Item : Link_Item) return String;
   function Name (Kind : Error_Kind) return String;
   function Name (Item : Status_Item) return String;
   function Name (Which : Node) return String;

   --  The function of a switch, for people (GND-50). Every page, display and
   --  report takes the text from here, through bin/urv_sim items.
   function Label (Switch : Switch_Item) return String is
     (case Switch is
         when Switch_1 => "rate damping",
         when Switch_2 => "attitude hold",
         when Switch_3 => "altitude and airspeed",
         when Switch_4 => "wings level",
         when Switch_5 => "test card",
         when Switch_6 => "discrete 6",
         when Switch_7 => "laws disconnect",
         when Switch_8 => "half flaps");

   --  The part of the aircraft that a switch works, besides its discrete:
   --  "laws", "flaps" or none.
   function Works (Switch : Switch_Item) return String is
     (case Switch is
         when Switch_1 .. Switch_5 | Switch_7 => "laws",
         when Switch_6                        => "",
         when Switch_8                        => "flaps");

   --  The modes of the control laws and the link, for people (EXT-3, EXT-5).
   function Label (Mode : Lateral_Mode) return String is
     (case Mode is
         when Direct        => "direct",
         when Damping       => "damping",
         when Bank_By_Stick => "bank by stick",
         when Wings_Level   => "wings level",
         when Orbit         => "orbit");
   function Label (Mode : Vertical_Mode) return String is
     (case Mode is
         when Direct         => "direct",
         when Damping        => "damping",
         when Pitch_By_Stick => "pitch by stick",
         when Hold_Altitude  => "altitude",
         when Glide          => "glide");
   function Label (Mode : Power_Mode) return String is
     (case Mode is
         when Direct        => "direct",
         when Hold_Airspeed => "airspeed",
         when Idle          => "idle");
   function Label (State : Link_State) return String;

   --  The names of the words in the laws' report; empty for the age, which no
   --  page shows.
   function Law_Word_Name (Which : URV.Law_Status.Report_Item) return String is
     (case Which is
         when URV.Law_Status.Active        => "modes",
         when URV.Law_Status.Invalid_Low   => "invalid_low",
         when URV.Law_Status.Invalid_High  => "invalid_high",
         when URV.Law_Status.Silent        => "silent",
         when URV.Law_Status.Failed        => "failed",
         when URV.Law_Status.Age           => "",
         when URV.Law_Status.Configuration => "configuration");

end Host.Names;
