--  SPDX-License-Identifier: Apache-2.0

--  The flight of each axis in a frame, after the modes are decided (EXT-3,
--  EXT-8, FTI-3): its target, its output, its integrator. The procedure
--  URV.Laws.Frames.Steer calls Fly.

with URV.Integrators; use URV.Integrators;
with URV.Law_Inputs;  use URV.Law_Inputs;

private package URV.Laws.Flying with Pure, SPARK_Mode is

   function Readings_Of (Checks : Check_Table) return Readings is
     (Bank       => Roll_Angle_Of (Word_Of (Checks, Roll_Attitude)),
      Pitch      => Pitch_Angle_Of (Word_Of (Checks, Pitch_Attitude)),
      Roll_Rate  => Roll_Rate_Of (Word_Of (Checks, Roll_Rate)),
      Pitch_Rate => Slow_Rate_Of (Word_Of (Checks, Pitch_Rate)),
      Yaw_Rate   => Slow_Rate_Of (Word_Of (Checks, Yaw_Rate)),
      Altitude   => Level_Of (Word_Of (Checks, Altitude)),
      Airspeed   => Level_Of (Word_Of (Checks, Airspeed)))
   with Global => null;

   --  The sticks as input of the laws. While the link is lost they are at
   --  rest, with the rudder held as a trim.
   type Sticks is record
      Is_Pilot         : Boolean;
      Roll, Pitch, Yaw : Demand;
      Throttle         : Lever;
   end record;

   --  Added: the inputs of a test card to the pilot's sticks.
   function Sticks_Of
     (Commands : Uplink_Buffer; Link : Link_State; Added : Stick_Inputs)
      return Sticks
   is
     (if Link in Lost
      then (Is_Pilot => False,
            Roll     => 0,
            Pitch    => 0,
            Yaw      =>
              Within (Demand_Of (Commands (Yaw)), -Held_Yaw, Held_Yaw),
            Throttle => Level_Of (Commands (Throttle)))
      else (Is_Pilot => True,
            Roll     => Stick_With (Demand_Of (Commands (Roll)), Added.Roll),
            Pitch    =>
              Stick_With (Demand_Of (Commands (Pitch)), Added.Pitch),
            Yaw      => Stick_With (Demand_Of (Commands (Yaw)), Added.Yaw),
            Throttle => Level_Of (Commands (Throttle))))
   with Global => null;

   --  The stick keeps an axis that it has. An axis released by a law returns
   --  to the stick when its output reaches the stick's word in one step, also
   --  while the stick moves. No axis is the stick's while the link is lost.
   function Is_Stick_Again
     (Was, Is_Direct, Is_Pilot : Boolean; Last, Stick, Step : Number)
      return Boolean
   is
     (Is_Pilot
      and then Is_Direct
      and then (Was or else abs (Last - Stick) <= Step))
   with Global => null, Pre => abs Last <= 4_095 and then abs Stick <= 4_095;

   --  Only one axis has changed.
   function Flies_Only (Which : Axis; Before, After : Memory) return Boolean
   is
     (Decides_The_Same (Before, After)
      and then
        (if Which /= Roll_Axis
         then After.Last.Roll = Before.Last.Roll
           and then After.Roll_Trim = Before.Roll_Trim
           and then After.Bank_Wanted = Before.Bank_Wanted
           and then After.Is_Stick (Roll_Axis) = Before.Is_Stick (Roll_Axis))
      and then
        (if Which /= Pitch_Axis
         then After.Last.Pitch = Before.Last.Pitch
           and then After.Pitch_Trim = Before.Pitch_Trim
           and then After.Pitch_Wanted = Before.Pitch_Wanted
           and then After.Is_Stick (Pitch_Axis)
                      = Before.Is_Stick (Pitch_Axis))
      and then
        (if Which /= Yaw_Axis
         then After.Last.Yaw = Before.Last.Yaw
           and then After.Is_Stick (Yaw_Axis) = Before.Is_Stick (Yaw_Axis))
      and then
        (if Which /= Throttle_Axis
         then After.Last.Throttle = Before.Last.Throttle
           and then After.Power_Trim = Before.Power_Trim
           and then After.Speed_Held = Before.Speed_Held
           and then After.Lever_Held = Before.Lever_Held
           and then After.Is_Stick (Throttle_Axis)
                      = Before.Is_Stick (Throttle_Axis)))
   with Ghost, Global => null;

   --  While a law flies, its integrator moves towards its demand, as measured
   --  by its own sensor.

   function Follows_Bank
     (Before, After : Memory; Was : Modes; Bank : Angle) return Boolean
   is
     (if Was.Lateral in Banked and then After.Flown.Lateral in Banked
      then Moves_With
        (Before.Roll_Trim, After.Roll_Trim,
         Wanted => After.Bank_Wanted, Measured => Bank))
   with Ghost, Global => null;

   function Follows_Pitch
     (Before, After : Memory; Was : Modes; Pitch : Angle) return Boolean
   is
     (if Was.Vertical in Pitched and then After.Flown.Vertical in Pitched
      then Moves_With
        (Before.Pitch_Trim, After.Pitch_Trim,
         Wanted => After.Pitch_Wanted, Measured => Pitch))
   with Ghost, Global => null;

   --  A test card's input to the demanded bank. The sum is within the bank of
   --  a full stick.
   function Moved_Bank (Aim : Bank_Command; Added : Increment)
                        return Bank_Command
   is
     (Within (Aim + Added * Angle_For_Word, -Most_Bank, Most_Bank))
   with Global => null;

   --  A test card's input to the demanded pitch, before its limits.
   function Moved_Pitch (Aim : Unlimited; Added : Increment)
                         return Unlimited
   is
     (Within
        (Aim + Added * Angle_For_Word, Unlimited'First, Unlimited'Last))
   with Global => null;

   --  A test card's input to the altitude that is held.
   function Moved_Height (Held : Level; Added : Increment) return Level is
     (Within (Held + Added, 0, Level'Last))
   with Global => null;

   --  A test card's input to the airspeed that is held.
   function Moved_Speed (Held : Level; Added : Increment) return Level is
     (Within (Held + Added, Least_Speed, Most_Speed))
   with Global => null;

   --  The airspeed that is demanded with this lever, and with this input of a
   --  test card.
   function Demanded_Speed
     (This : Memory; Input : Lever; Added : Increment) return Level
   is
     (Moved_Speed
        (Held_Speed (This.Speed_Held, Input - This.Lever_Held), Added))
   with Global => null;

   --  Only the lever and a test card change the demanded airspeed.
   function Follows_Speed
     (Before, After : Memory;
      Was           : Modes;
      Airspeed      : Level;
      Input         : Lever;
      Added         : Increment) return Boolean
   is
     (if Was.Power = Hold_Airspeed and then After.Flown.Power = Hold_Airspeed
      then After.Speed_Held = Before.Speed_Held
        and then After.Lever_Held = Before.Lever_Held
        and then Moves_With
          (Before.Power_Trim, After.Power_Trim,
           Wanted   => Demanded_Speed (After, Input, Added),
           Measured => Airspeed))
   with Ghost, Global => null;

   --  Added, Extra: a test card's inputs to the laws' commands.

   procedure Fly_Roll
     (This  : in out Memory;
      Was   : Modes;
      Now   : Readings;
      Input : Sticks;
      By    : Gain_Table;
      Added : Increment)
   with
     Global => null,
     Post   =>
       Flies_Only (Roll_Axis, This'Old, This)
       and then
         (if This.Is_Stick (Roll_Axis)
          then Input.Is_Pilot and then This.Last.Roll = Input.Roll)
       and then
         (if This.Is_Stick'Old (Roll_Axis)
            and then This.Flown.Lateral = Direct
            and then Input.Is_Pilot
          then This.Is_Stick (Roll_Axis))
       and then
         (if not (This.Is_Stick'Old (Roll_Axis)
                  and then This.Is_Stick (Roll_Axis))
          then abs (This.Last.Roll - This.Last'Old.Roll) <= Roll_Step)
       and then
         (if This.Flown.Lateral in Banked
          then abs This.Last.Roll <= Integer'Max
                 (Roll_Authority, abs This.Last'Old.Roll - Roll_Step))

       and then Follows_Bank (This'Old, This, Was, Now.Bank);

   procedure Fly_Yaw (This : in out Memory; Now : Readings; Input : Sticks)
   with
     Global => null,
     Post   =>
       Flies_Only (Yaw_Axis, This'Old, This)
       and then
         (if This.Is_Stick (Yaw_Axis)
          then Input.Is_Pilot and then This.Last.Yaw = Input.Yaw)
       and then
         (if This.Is_Stick'Old (Yaw_Axis)
            and then This.Flown.Lateral = Direct
            and then Input.Is_Pilot
          then This.Is_Stick (Yaw_Axis))
       and then
         (if not (This.Is_Stick'Old (Yaw_Axis)
                  and then This.Is_Stick (Yaw_Axis))
          then abs (This.Last.Yaw - This.Last'Old.Yaw) <= Yaw_Step);

   procedure Fly_Pitch
     (This   : in out Memory;
      Was    : Modes;
      Now    : Readings;
      Input  : Sticks;
      Rising : Climb_Reading;
      By     : Gain_Table;
      Extra  : Command_Inputs)
   with
     Global => null,
     Post   =>
       Flies_Only (Pitch_Axis, This'Old, This)
       and then
         (if This.Is_Stick (Pitch_Axis)
          then Input.Is_Pilot and then This.Last.Pitch = Input.Pitch)
       and then
         (if This.Is_Stick'Old (Pitch_Axis)
            and then This.Flown.Vertical = Direct
            and then Input.Is_Pilot
          then This.Is_Stick (Pitch_Axis))
       and then
         (if not (This.Is_Stick'Old (Pitch_Axis)
                  and then This.Is_Stick (Pitch_Axis))
          then abs (This.Last.Pitch - This.Last'Old.Pitch) <= Pitch_Step)
       and then
         (if This.Flown.Vertical in Pitched
          then abs This.Last.Pitch <= Integer'Max
                 (Pitch_Authority, abs This.Last'Old.Pitch - Pitch_Step))

       and then Follows_Pitch (This'Old, This, Was, Now.Pitch)

       --  The altitude's integrator moves towards the demanded climb rate.
       and then
         (if This.Flown.Vertical = Hold_Altitude
            and then Was.Vertical in Pitched
          then Moves_With
            (This.Height_Trim'Old, This.Height_Trim,
             Wanted   =>
               Wanted_Climb
                 (Moved_Height (This.Height_Held, Extra.Altitude), Now),
             Measured => Rising))
       and then
         (if This.Flown.Vertical = Hold_Altitude
            and then Was.Vertical = Hold_Altitude
          then This.Height_Held = This.Height_Held'Old);

   procedure Fly_Throttle
     (This  : in out Memory;
      Was   : Modes;
      Now   : Readings;
      Input : Sticks;
      Extra : Command_Inputs)
   with
     Global => null,
     Post   =>
       Flies_Only (Throttle_Axis, This'Old, This)
       and then
         (if This.Is_Stick (Throttle_Axis)
          then Input.Is_Pilot and then This.Last.Throttle = Input.Throttle)
       and then
         (if This.Is_Stick'Old (Throttle_Axis)
            and then This.Flown.Power = Direct
            and then Input.Is_Pilot
          then This.Is_Stick (Throttle_Axis))
       and then
         (if not (This.Is_Stick'Old (Throttle_Axis)
                  and then This.Is_Stick (Throttle_Axis))
          then abs (This.Last.Throttle - This.Last'Old.Throttle) <=
                 Throttle_Step)

       and then
         Follows_Speed
           (This'Old, This, Was, Now.Airspeed, Input.Throttle,
            Extra.Airspeed);

   --  Flies all four axes.
   procedure Fly
     (This   : in out Memory;
      Was    : Modes;
      Now    : Readings;
      Input  : Sticks;
      Rising : Climb_Reading;
      By     : Gain_Table;
      Extra  : Command_Inputs)
   with
     Global => null,
     Post   =>
       Decides_The_Same (This'Old, This)
       and then
         (for all Which in Axis =>
            (if This.Is_Stick (Which) then Input.Is_Pilot))
       and then
         (if Is_All_Stick (This'Old)
            and then This.Flown = All_Direct
            and then Input.Is_Pilot
          then Is_All_Stick (This))
       and then
         (if not This.Is_Stick (Roll_Axis)
          then abs (This.Last.Roll - This.Last'Old.Roll) <= Roll_Step)
       and then
         (if not This.Is_Stick (Pitch_Axis)
          then abs (This.Last.Pitch - This.Last'Old.Pitch) <= Pitch_Step)
       and then
         (if not This.Is_Stick (Yaw_Axis)
          then abs (This.Last.Yaw - This.Last'Old.Yaw) <= Yaw_Step)
       and then
         (if not This.Is_Stick (Throttle_Axis)
          then abs (This.Last.Throttle - This.Last'Old.Throttle) <=
                 Throttle_Step)
       and then
         (if This.Flown.Lateral in Banked
          then abs This.Last.Roll <= Integer'Max
                 (Roll_Authority, abs This.Last'Old.Roll - Roll_Step))
       and then
         (if This.Flown.Vertical in Pitched
          then abs This.Last.Pitch <= Integer'Max
                 (Pitch_Authority, abs This.Last'Old.Pitch - Pitch_Step))
       and then Follows_Bank (This'Old, This, Was, Now.Bank)
       and then Follows_Pitch (This'Old, This, Was, Now.Pitch)
       and then
         Follows_Speed
           (This'Old, This, Was, Now.Airspeed, Input.Throttle,
            Extra.Airspeed);

end URV.Laws.Flying;
