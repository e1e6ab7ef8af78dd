--  SPDX-License-Identifier: Apache-2.0

--  A frame of the control laws (EXT-3, EXT-5, EXT-8, FTI-3, D-100).
--
--     Observe (Memory, Commands, Sensors, By, Seen);
--     Steer (Memory, Commands, Seen, Sticks, Extra);
--     Flown := Output (Memory, Commands, Sticks);
--
--  Observe decides the modes of a frame, Steer flies them. Between them the
--  caller decides the inputs of a test card, zero without one.

with URV.Integrators; use URV.Integrators;
with URV.Law_Inputs;  use URV.Law_Inputs;
with URVOS;           use URVOS;

package URV.Laws.Frames with Pure, SPARK_Mode is

   --  The frame's decisions: link, sensors, modes.
   function Is_Observed
     (Before, After : Memory;
      Commands      : Uplink_Buffer;
      Sensors       : Downlink_Buffer;
      By            : Times) return Boolean
   is
     (After.Link =
        Link_Loss.Next
          (Before.Link, not Is_Old (Commands), Is_On (Commands (Switch_7)), By)
      and then After.Checks = Sensor_Checks.Next (Before.Checks, Sensors)
      and then
        (if Is_Old (Commands) then After.Heard = Before.Heard
         else After.Heard = Commands)
      and then After.Is_Flying =
        (if After.Link.State in Lost then Before.Is_Flying
         else not Is_On_Ground (Sensor_Checks.Next (Before.Checks, Sensors)))
      and then After.Flown =
        (if Is_Disconnected (Commands) then All_Direct
         else Allowed
           (Wanted
              (After.Link.State,
               (if Is_Old (Commands) then Before.Heard else Commands),
               After.Is_Flying),
            Sensor_Checks.Next (Before.Checks, Sensors))))
   with Ghost, Global => null;

   --  The laws' work in the frame, with these modes in the frame before.
   function Is_Steered
     (Before, After : Memory;
      Was           : Modes;
      Commands      : Uplink_Buffer) return Boolean
   is
     --  No law flies after a disconnect, at once, and before the first
     --  commands.
     ((if Is_Disconnected (Commands) and then After.Flown = All_Direct
       then Is_All_Stick (After))
      and then
        (if After.Link.State = Waiting and then After.Flown = All_Direct
         then Is_All_Stick (After))

      --  While the link is lost no axis is the stick's.
      and then
        (if After.Link.State in Lost and then not Is_Disconnected (Commands)
         then (for all Which in Axis => not After.Is_Stick (Which)))

      --  A law's output has moved within its rate limit, whatever the modes
      --  were.
      and then
        (if not After.Is_Stick (Roll_Axis)
         then abs (After.Last.Roll - Before.Last.Roll) <= Roll_Step)
      and then
        (if not After.Is_Stick (Pitch_Axis)
         then abs (After.Last.Pitch - Before.Last.Pitch) <= Pitch_Step)
      and then
        (if not After.Is_Stick (Yaw_Axis)
         then abs (After.Last.Yaw - Before.Last.Yaw) <= Yaw_Step)
      and then
        (if not After.Is_Stick (Throttle_Axis)
         then abs (After.Last.Throttle - Before.Last.Throttle)
                <= Throttle_Step)

      --  A law of bank or pitch is within its authority, or moves towards it.
      and then
        (if After.Flown.Lateral in Banked
         then abs After.Last.Roll <= Integer'Max
                (Roll_Authority, abs Before.Last.Roll - Roll_Step))
      and then
        (if After.Flown.Vertical in Pitched
         then abs After.Last.Pitch <= Integer'Max
                (Pitch_Authority, abs Before.Last.Pitch - Pitch_Step))

      --  Roll and pitch are trimmed the right way, by their own sensors.
      and then
        (if Was.Lateral in Banked
           and then After.Flown.Lateral in Banked
         then Moves_With
           (Before.Roll_Trim, After.Roll_Trim,
            Wanted   => After.Bank_Wanted,
            Measured =>
              Roll_Angle_Of (Word_Of (After.Checks, Roll_Attitude))))
      and then
        (if Was.Vertical in Pitched
           and then After.Flown.Vertical in Pitched
         then Moves_With
           (Before.Pitch_Trim, After.Pitch_Trim,
            Wanted   => After.Pitch_Wanted,
            Measured =>
              Pitch_Angle_Of (Word_Of (After.Checks, Pitch_Attitude)))))
   with Ghost, Global => null;

   --  The memory from frame to frame. All of a law's work is in it.
   function Is_Frame
     (Before, After : Memory;
      Commands      : Uplink_Buffer;
      Sensors       : Downlink_Buffer;
      By            : Times) return Boolean
   is
     (Is_Observed (Before, After, Commands, Sensors, By)
      and then Is_Steered (Before, After, Before.Flown, Commands)
      and then (if Is_Disconnected (Commands) then Is_All_Stick (After))
      and then (if After.Link.State = Waiting then Is_All_Stick (After)))
   with Ghost, Global => null;

   --  The facts of a frame that its laws need besides the memory: the modes
   --  of the frame before, and the measured climb rate.
   type Observation is record
      Was    : Modes;
      Rising : Climb_Reading;
   end record;

   --  The outputs, references and integrators wait for Steer.
   procedure Observe
     (This     : in out Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Seen     : out Observation)
   with
     Global => null,
     Post   =>
       Is_Observed (This'Old, This, Commands, Sensors, By)
       and then Seen.Was = This.Flown'Old
       and then This.Is_Stick = This.Is_Stick'Old
       and then This.Last.Roll = This.Last.Roll'Old
       and then This.Last.Pitch = This.Last.Pitch'Old
       and then This.Last.Yaw = This.Last.Yaw'Old
       and then This.Last.Throttle = This.Last.Throttle'Old
       and then This.Roll_Trim = This.Roll_Trim'Old
       and then This.Pitch_Trim = This.Pitch_Trim'Old;

   --  Sticks, Extra: the inputs of a test card to the sticks and to the laws'
   --  commands. Commands are those of Observe.
   procedure Steer
     (This     : in out Memory;
      Commands : Uplink_Buffer;
      Seen     : Observation;
      Sticks   : Stick_Inputs;
      Extra    : Command_Inputs;
      Table    : Table_Number := 0)
   with
     Global => null,
     Post   =>
       Decides_The_Same (This'Old, This)
       and then Is_Steered (This'Old, This, Seen.Was, Commands);

   --  Both as a function, for theorems and tests.
   function Next
     (This     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number   := 0;
      Sticks   : Stick_Inputs   := No_Sticks;
      Extra    : Command_Inputs := No_Commands) return Memory
   with
     Global => null,
     Post   => Is_Frame (This, Next'Result, Commands, Sensors, By);

   --  The commands after the laws, with the pilot's own words on each axis
   --  that is the stick's, and a test card's input to it. If all are, it is
   --  the same message with its mark; otherwise it is a message that is not
   --  marked as old.
   function Output
     (This     : Memory;
      Commands : Uplink_Buffer;
      Sticks   : Stick_Inputs := No_Sticks) return Uplink_Buffer
   is
     (if Is_All_Stick (This) then Commands
      else
        (This.Heard with delta
           Roll         => (if This.Is_Stick (Roll_Axis)
                            then Stick_Word (This.Heard (Roll), Sticks.Roll)
                            else Word_Of (This.Last.Roll)),
           Pitch        => (if This.Is_Stick (Pitch_Axis)
                            then Stick_Word (This.Heard (Pitch), Sticks.Pitch)
                            else Word_Of (This.Last.Pitch)),
           Yaw          => (if This.Is_Stick (Yaw_Axis)
                            then Stick_Word (This.Heard (Yaw), Sticks.Yaw)
                            else Word_Of (This.Last.Yaw)),
           Throttle     => (if This.Is_Stick (Throttle_Axis)
                            then This.Heard (Throttle)
                            else Lever_Word_Of (This.Last.Throttle)),
           Error_Status => No_Error))
   with
     Global => null,
     Post   =>
       (if Is_All_Stick (This)
        then Output'Result = Commands
        else not Is_Old (Output'Result)
          and then Output'Result (Brake) = This.Heard (Brake)
          and then (for all Switch in Switch_Item =>
                      Output'Result (Switch) = This.Heard (Switch)));

end URV.Laws.Frames;
