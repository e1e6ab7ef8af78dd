--  SPDX-License-Identifier: Apache-2.0

--  The ground converter's input to the node when the pilot's console falls
--  silent (SAF-10, FRM-7, D-33).
--
--  A lost console in flight has the same effect as a lost link. The converter
--  delivers no scan, so GDCOUT marks the uplink as old, and the aircraft
--  holds, orbits and glides by its link-loss rule (EXT-5). On the ground the
--  uplink carries the safe words: throttle idle, brake on, switches off.
--
--  A frame is silent if no console input came in it. Unless the ground knows
--  that the aircraft is on the ground, the aircraft counts as flying.

with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Frame_Times;   use URV.Frame_Times;
with URV.Sensor_Checks; use URV.Sensor_Checks;

package URV.Console_Watch with Pure, SPARK_Mode is

   --  Live        the scan has the words of the last console input
   --  Held        there is no scan: nothing fresh goes up
   --  Safe_Words  the scan has the safe words, Neutral_Stick_Words (D-13)
   type Converter_Input is (Live, Held, Safe_Words);

   --  Silent frames in a row. The last value means that number or more.
   type Frame_Count is range 0 .. 1_000_000;

   --  Silent frames before the console is lost, 0.5 s, and before the safe
   --  words may be sent, 2 s.
   Lost_After : constant Frame_Count := 5 * Frames_Per_Tenth;
   Safe_After : constant Frame_Count := 2 * Frames_Per_Second;

   function Is_Lost (Silent : Frame_Count) return Boolean is
     (Silent >= Lost_After)
   with Global => null;

   --  The ground's checks of the aircraft's sensors, from the downlinks in
   --  CORE, and the converter's input to the node. At the start no sensor is
   --  valid.
   type Watch is record
      Checks : Check_Table;
      Input  : Converter_Input := Held;
   end record;

   --  The downlink in CORE. A cleared one counts as marked old.
   function Downlink_Of (Area : Downlink_Buffer) return Downlink_Buffer is
     (if (for all Item of Area => Item = 0) then Neutral_Downlink
      else Area)
   with Global => null;

   --  The watch after a frame. Silent counts the frames up to this one.
   --  Downlink is the latest downlink, marked as old unless it came in the
   --  last frame.
   function Next
     (This     : Watch;
      Silent   : Frame_Count;
      Downlink : Downlink_Buffer) return Watch
   is
     (Checks => Sensor_Checks.Next (This.Checks, Downlink),
      Input  =>
        (if not Is_Lost (Silent) then Live
         elsif Silent >= Safe_After
           and then Is_On_Ground (Sensor_Checks.Next (This.Checks, Downlink))
         then Safe_Words
         else Held))
   with Global => null;

end URV.Console_Watch;
