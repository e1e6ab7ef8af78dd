--  SPDX-License-Identifier: Apache-2.0

--  A pilot's console that falls silent does not endanger the aircraft (SAF-10,
--  D-33). In flight the aircraft acts as after a lost link; on the ground it
--  gets the safe words: throttle idle, brake on, switches off. This holds for
--  any history of console inputs and downlinks of up to a million frames. The
--  ground must know from valid sensors that the aircraft is on the ground;
--  otherwise it counts as flying.

with URV.Buffers;       use URV.Buffers;
with URV.Console_Watch; use URV.Console_Watch;
with URV.Laws;          use type URV.Laws.Memory, URV.Laws.Modes;
with URV.Laws.Frames;
with URV.Link_Loss;     use type URV.Link_Loss.Link_Memory;
with URV.Mailboxes;     use URV.Mailboxes;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Routing;       use URV.Routing;
with URV.Sensor_Checks; use URV.Sensor_Checks;
with URV.Type_Codes;    use URV.Type_Codes;
with URVOS;             use URVOS;
with Theorems.Safety;   use Theorems.Safety;

package Theorems.Lost_Console with SPARK_Mode, Ghost is

   use For_Stick_Words.Boxes;
   use For_Uplink.Boxes;

   --  In flight a lost console gives no fresh command: the converter delivers
   --  no scan, and GDCOUT marks the uplink as old. A console order is still
   --  sent. No earlier scan may be pending.
   procedure In_Flight_Nothing_Fresh_Goes_Up
     (Ground     : in out Ground_Way;
      Scans      : Scan_History;
      Item       : Watch;
      Silent     : Frame_Count;
      Downlink   : Downlink_Buffer;
      Bits       : Word;
      Order      : Uplink_Buffer;
      Is_Ordered : Boolean)
   with
     Global => null,
     Pre    =>
       Is_Sound (Ground, Scans)
       and then not Is_Fresh (Ground.ADINT)
       and then Is_Lost (Silent)
       and then not Is_On_Ground (Next (Item, Silent, Downlink).Checks),
     Post   =>
       Next (Item, Silent, Downlink).Input = Held
       and then
         (Is_Old (Contents (Ground.TELOUT))
          or else Is_Other_Kind (Contents (Ground.TELOUT)));

   --  The console input and the downlink of each frame, without restriction

   type Frame is record
      Has_Input : Boolean;
      Downlink  : Downlink_Buffer;
   end record;

   Last_Frame : constant := 1_000_000;
   type Frame_Number is range 1 .. Last_Frame;
   type Frame_History is array (Frame_Number) of Frame;

   --  None of the last 25 frames had console input.
   function Is_Lost_At (Frames : Frame_History; Where : Frame_Number)
                        return Boolean
   is
     (Where >= Frame_Number (Lost_After)
      and then
        (for all Each in Frame_Number =>
           (if Each > Where - Frame_Number'Base (Lost_After)
              and then Each <= Where
            then not Frames (Each).Has_Input)))
   with Global => null;

   --  For any history: with a lost console, fresh words are sent only if the
   --  aircraft is known to be on the ground, and they are the safe words.
   --  While the console is not lost, its own words are sent.
   procedure Any_History
     (Frames : Frame_History; Upto : Frame_Number; Item : out Watch)
   with
     Global => null,
     Post   =>
       (if Is_Lost_At (Frames, Upto)
        then Item.Input /= Live
          and then
            (if not Is_On_Ground (Item.Checks) then Item.Input = Held)
        else Item.Input = Live);

   --  The aircraft cannot distinguish a lost console from a lost link. Any two
   --  commands marked as old cause the same silent frame: link state, sensors,
   --  remembered commands and active modes are equal.
   procedure Same_Effect_As_A_Lost_Link
     (Before       : URV.Laws.Memory;
      From_Console : Uplink_Buffer;
      From_Link    : Uplink_Buffer;
      Sensors      : Downlink_Buffer;
      By           : URV.Link_Loss.Times;
      One, Other   : URV.Laws.Memory)
   with
     Global => null,
     Pre    =>
       Is_Old (From_Console)
       and then Is_Old (From_Link)
       and then One = URV.Laws.Frames.Next (Before, From_Console, Sensors, By)
       and then Other = URV.Laws.Frames.Next (Before, From_Link, Sensors, By),
     Post   =>
       One.Link = URV.Link_Loss.After_Silence (Before.Link, By)
       and then One.Link = Other.Link
       and then One.Checks = Other.Checks
       and then One.Heard = Other.Heard
       and then One.Is_Flying = Other.Is_Flying
       and then One.Flown = Other.Flown;

   --  On the ground the safe words are sent as fresh commands from the frame
   --  in which the console has been silent for 2 s: throttle idle, brake on,
   --  switches off.
   procedure On_The_Ground_The_Safe_Words_Go_Up
     (Item     : Watch;
      Silent   : Frame_Count;
      Downlink : Downlink_Buffer)
   with
     Global => null,
     Pre    =>
       Silent >= Safe_After
       and then Is_On_Ground (Next (Item, Silent, Downlink).Checks),
     Post   =>
       Next (Item, Silent, Downlink).Input = Safe_Words
       and then
         not Is_Old (To_Uplink (Stamped (Neutral_Stick_Words, Fresh => True)))
       and then
         Transform (To_Uplink (Stamped (Neutral_Stick_Words, Fresh => True)))
           = Safe_Outputs;

   --  The console has control again with its first input.
   procedure It_Is_Back_With_Its_First_Input
     (Item : Watch; Downlink : Downlink_Buffer)
   with
     Global => null,
     Post   => Next (Item, 0, Downlink).Input = Live;

end Theorems.Lost_Console;
