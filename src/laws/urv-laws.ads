--  SPDX-License-Identifier: Apache-2.0

--  The control laws, between the pilot's commands and the servos (EXT-3,
--  EXT-5, EXT-8). docs/control-laws.md describes their flight, URV.Laws.Frames
--  has a frame of them.
--
--  A law replaces four of the commands: roll, pitch, yaw, throttle. Figure 13
--  converts the result to servo words, as it does the pilot's own commands.
--  The brake and the switches, including flaps and discretes, come from the
--  last commands that were not marked as old.

with URV.Buffers;       use URV.Buffers;
with URV.Law_Axes;      use URV.Law_Axes;
with URV.Law_Gains;     use URV.Law_Gains;
with URV.Law_Units;     use URV.Law_Units;
with URV.Link_Loss;     use URV.Link_Loss;
with URV.PWM_Transform; use URV.PWM_Transform;
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

end URV.Laws;
