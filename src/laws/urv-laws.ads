--  SPDX-License-Identifier: Apache-2.0

--  The control laws, between the pilot's commands and the servos (EXT-3,
--  EXT-5, EXT-8). docs/control-laws.md describes their flight.
--
--     Observe (Memory, Commands, Sensors, By, Seen);
--     Steer (Memory, Commands, Seen, Sticks, Extra);
--     Flown := Output (Memory, Commands, Sticks);
--
--  Observe decides the modes of a frame, Steer flies them. Between them the
--  caller decides the inputs of a test card, zero without one.
--
--  A law replaces four of the commands: roll, pitch, yaw, throttle. Figure 13
--  converts the result to servo words, as it does the pilot's own commands.
--  The brake and the switches, including flaps and discretes, come from the
--  last commands that were not marked as old.

with URVOS;             use URVOS;
with URV.Buffers;       use URV.Buffers;
with URV.Integrators;   use URV.Integrators;
with URV.Law_Axes;      use URV.Law_Axes;
with URV.Law_Gains;     use URV.Law_Gains;
with URV.Law_Inputs;    use URV.Law_Inputs;
with URV.Law_Units;     use URV.Law_Units;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.PWM_Transform; use URV.PWM_Transform;
with URV.Routing;       use URV.Routing;
with URV.Sensor_Checks; use URV.Sensor_Checks;

package URV.Laws with Pure, SPARK_Mode is

   --  The node's settings: whether the laws are on, the times of the link-loss
   --  rule, and the table of gains.
   type Settings is record
      On    : Boolean := False;
      By    : Times;
      Table : Table_Number := 0;
   end record;

   --  The mode of each axis. Direct is the stick itself. Yaw follows Lateral.
   type Lateral_Mode is (Direct, Damping, Bank_By_Stick, Wings_Level, Orbit);
   type Vertical_Mode is
     (Direct, Damping, Pitch_By_Stick, Hold_Altitude, Glide);
   type Power_Mode is (Direct, Hold_Airspeed, Idle);

   subtype Banked is Lateral_Mode range Bank_By_Stick .. Orbit;
   subtype Pitched is Vertical_Mode range Pitch_By_Stick .. Glide;

   type Modes is record
      Lateral  : Lateral_Mode  := Direct;
      Vertical : Vertical_Mode := Direct;
      Power    : Power_Mode    := Direct;
   end record
   with Alignment => 2;

   All_Direct : constant Modes := (others => <>);

   --  The outputs of a frame.
   type Outputs is record
      Roll, Pitch, Yaw : Demand := 0;
      Throttle         : Lever  := 0;
   end record;

   --  The outputs that are the stick's own words again after a law has ended.
   type Axis is (Roll_Axis, Pitch_Axis, Yaw_Axis, Throttle_Axis);
   type Axis_Flags is array (Axis) of Boolean
   with Alignment => 2;

   type Memory is record
      Link     : Link_Memory;
      Checks   : Check_Table;
      Flown    : Modes;
      Is_Stick : Axis_Flags := (others => True);
      Last     : Outputs;

      --  The last commands that were not marked as old.
      Heard    : Uplink_Buffer := Neutral_Uplink;

      --  The aircraft flies. If the link is lost it flies on; on the ground it
      --  idles.
      Is_Flying : Boolean := False;

      --  References and integrators of the laws
      Bank_Wanted  : Bank_Command         := 0;
      Pitch_Wanted : Pitch_Command        := Level_Pitch;
      Height_Held  : Level                := 0;
      Speed_Held   : Level                := 0;
      Lever_Held   : Lever                := 0;
      Roll_Trim    : Law_Axes.Roll_Trim   := 0;
      Pitch_Trim   : Law_Axes.Pitch_Trim  := 0;
      Height_Trim  : Law_Axes.Height_Trim := 0;
      Power_Trim   : Law_Axes.Power_Trim  := 0;
      Smoothed     : Smooth               := 0;
   end record;

   --  The state after a cold start, and the default settings

   function At_Start return Memory is (others => <>)
   with Global => null;

   function Laws_Off return Settings is
     (On    => False,
      By    => (Hold         => Hold_After,
                Orbit        => Orbit_After,
                Terminate_At => Terminate_After),
      Table => 0)
   with Global => null;

   --  No law flies the aircraft.
   function Is_All_Stick (This : Memory) return Boolean is
     (for all Which in Axis => This.Is_Stick (Which))
   with Global => null;

   --  The pilot's disconnect switch: direct, with priority over all else.
   function Is_Disconnected (Commands : Uplink_Buffer) return Boolean is
     (not Is_Old (Commands) and then Is_On (Commands (Switch_7)))
   with Global => null;

   --  The modes that the switches demand while the pilot flies.
   function Asked (Commands : Uplink_Buffer) return Modes is
     (if Is_On (Commands (Switch_7)) then All_Direct
      else
        (Lateral  =>
           (if Is_On (Commands (Switch_4)) then Wings_Level
            elsif Is_On (Commands (Switch_2))
              or else Is_On (Commands (Switch_3))
            then Bank_By_Stick
            elsif Is_On (Commands (Switch_1)) then Damping
            else Direct),
         Vertical =>
           (if Is_On (Commands (Switch_3))
              and then abs Demand_Of (Commands (Pitch)) <= Stick_Rest
            then Hold_Altitude
            elsif Is_On (Commands (Switch_2))
              or else Is_On (Commands (Switch_3))
            then Pitch_By_Stick
            elsif Is_On (Commands (Switch_1)) then Damping
            else Direct),
         Power    =>
           (if Is_On (Commands (Switch_3)) then Hold_Airspeed
            else Direct)))
   with Global => null;

   --  The modes that the link's state demands.
   function Wanted
     (Link : Link_State; Commands : Uplink_Buffer; Is_Flying : Boolean)
      return Modes
   is
     (case Link is
         when Waiting    => All_Direct,
         when Linked     => Asked (Commands),
         when Holding    =>
           (if Is_Flying then (Wings_Level, Hold_Altitude, Hold_Airspeed)
            else (Direct, Direct, Idle)),
         when Orbiting   =>
           (if Is_Flying then (Orbit, Hold_Altitude, Hold_Airspeed)
            else (Direct, Direct, Idle)),
         when Terminated =>
           (if Is_Flying then (Wings_Level, Glide, Idle)
            else (Direct, Direct, Idle)))
   with Global => null;

   --  The modes that the valid sensors permit. Each law needs its own sensors,
   --  and falls back to one that needs fewer.

   function Can_Damp_Roll (Checks : Check_Table) return Boolean is
     (Checks (Roll_Rate).Is_Valid)
   with Global => null;

   function Can_Bank (Checks : Check_Table) return Boolean is
     (Checks (Roll_Rate).Is_Valid and then Checks (Roll_Attitude).Is_Valid)
   with Global => null;

   function Can_Damp_Pitch (Checks : Check_Table) return Boolean is
     (Checks (Pitch_Rate).Is_Valid and then Checks (Roll_Attitude).Is_Valid)
   with Global => null;

   function Can_Pitch (Checks : Check_Table) return Boolean is
     (Can_Damp_Pitch (Checks) and then Checks (Pitch_Attitude).Is_Valid)
   with Global => null;

   function Can_Damp_Yaw (Checks : Check_Table) return Boolean is
     (Checks (Yaw_Rate).Is_Valid and then Checks (Roll_Attitude).Is_Valid)
   with Global => null;

   function Allowed (Item : Modes; Checks : Check_Table) return Modes is
     (Lateral  =>
        (case Item.Lateral is
            when Banked  =>
              (if Can_Bank (Checks) then Item.Lateral
               elsif Can_Damp_Roll (Checks) then Damping
               else Direct),
            when Damping =>
              (if Can_Damp_Roll (Checks) then Damping else Direct),
            when Direct  => Direct),
      Vertical =>
        (case Item.Vertical is
            when Pitched =>
              (if Can_Pitch (Checks)
               then
                 (if Item.Vertical = Hold_Altitude
                    and then not Checks (Altitude).Is_Valid
                  then Pitch_By_Stick
                  else Item.Vertical)
               elsif Can_Damp_Pitch (Checks) then Damping
               else Direct),
            when Damping =>
              (if Can_Damp_Pitch (Checks) then Damping else Direct),
            when Direct  => Direct),
      Power    =>
        (if Item.Power = Hold_Airspeed
           and then not Checks (Airspeed).Is_Valid
         then Direct
         else Item.Power))
   with
     Global => null,
     Post   =>
       (if Allowed'Result.Lateral /= Direct
        then Checks (Roll_Rate).Is_Valid)
       and then (if Allowed'Result.Lateral in Banked
                 then Checks (Roll_Attitude).Is_Valid)
       and then (if Allowed'Result.Vertical /= Direct
                 then Checks (Pitch_Rate).Is_Valid
                   and then Checks (Roll_Attitude).Is_Valid)
       and then (if Allowed'Result.Vertical in Pitched
                 then Checks (Pitch_Attitude).Is_Valid)
       and then (if Allowed'Result.Vertical = Hold_Altitude
                 then Checks (Altitude).Is_Valid)
       and then (if Allowed'Result.Power = Hold_Airspeed
                 then Checks (Airspeed).Is_Valid);

   --  Nothing decided for the frame is different: link, sensors, modes.
   function Decides_The_Same (Before, After : Memory) return Boolean is
     (After.Link = Before.Link
      and then After.Checks = Before.Checks
      and then After.Flown = Before.Flown
      and then After.Heard = Before.Heard
      and then After.Is_Flying = Before.Is_Flying)
   with Ghost, Global => null;

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
   --  of the frame before, and the measured climb rate in thousandths of a
   --  foot a second.
   subtype Climb_Reading is Number range -30_000 .. 30_000;

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

   --  Both without test inputs, as a function for theorems and tests.
   function Next
     (This : Memory; Commands : Uplink_Buffer; Sensors : Downlink_Buffer;
      By : Times; Table : Table_Number := 0) return Memory
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

end URV.Laws;
