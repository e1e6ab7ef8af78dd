--  SPDX-License-Identifier: Apache-2.0

with URV.Integrators; use URV.Integrators;

package body URV.Laws with SPARK_Mode is

   function Readings_Of (Checks : Check_Table) return Readings is
     (Bank       => Roll_Angle_Of (Word_Of (Checks, Roll_Attitude)),
      Pitch      => Pitch_Angle_Of (Word_Of (Checks, Pitch_Attitude)),
      Roll_Rate  => Roll_Rate_Of (Word_Of (Checks, Roll_Rate)),
      Pitch_Rate => Slow_Rate_Of (Word_Of (Checks, Pitch_Rate)),
      Yaw_Rate   => Slow_Rate_Of (Word_Of (Checks, Yaw_Rate)),
      Altitude   => Level_Of (Word_Of (Checks, Altitude)),
      Airspeed   => Level_Of (Word_Of (Checks, Airspeed)))
   with Global => null;

   --  The sticks as a law reads them: at rest while the link is lost, the
   --  rudder held as a trim.
   type Sticks is record
      Is_Pilot         : Boolean;
      Roll, Pitch, Yaw : Demand;
      Throttle         : Lever;
   end record;

   function Sticks_Of (Commands : Uplink_Buffer; Link : Link_State)
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
            Roll     => Demand_Of (Commands (Roll)),
            Pitch    => Demand_Of (Commands (Pitch)),
            Yaw      => Demand_Of (Commands (Yaw)),
            Throttle => Level_Of (Commands (Throttle))))
   with Global => null;

   --  An axis that is the stick's stays so. One that a law has let go
   --  becomes so when its output has come to the stick. None is while the
   --  link is lost.
   function Is_Stick_Again
     (Was, Is_Direct, Is_Pilot : Boolean; Last, Stick : Number)
      return Boolean
   is
     (Is_Pilot and then Is_Direct and then (Was or else Last = Stick))
   with Global => null;

   --  Flying changes nothing of what was decided before.
   function Decides_The_Same (Before, After : Memory) return Boolean is
     (After.Link = Before.Link
      and then After.Checks = Before.Checks
      and then After.Flown = Before.Flown
      and then After.Heard = Before.Heard
      and then After.Is_Flying = Before.Is_Flying)
   with Ghost, Global => null;

   --  Of what a frame decides a law has flown one axis, and nothing else.
   function Flies_Only (Which : Axis; Before, After : Memory) return Boolean
   is
     (Decides_The_Same (Before, After)
      and then
        (if Which /= Roll_Axis
         then After.Last.Roll = Before.Last.Roll
           and then After.Is_Stick (Roll_Axis) = Before.Is_Stick (Roll_Axis))
      and then
        (if Which /= Pitch_Axis
         then After.Last.Pitch = Before.Last.Pitch
           and then After.Is_Stick (Pitch_Axis)
                      = Before.Is_Stick (Pitch_Axis))
      and then
        (if Which /= Yaw_Axis
         then After.Last.Yaw = Before.Last.Yaw
           and then After.Is_Stick (Yaw_Axis) = Before.Is_Stick (Yaw_Axis))
      and then
        (if Which /= Throttle_Axis
         then After.Last.Throttle = Before.Last.Throttle
           and then After.Is_Stick (Throttle_Axis)
                      = Before.Is_Stick (Throttle_Axis)))
   with Ghost, Global => null;

   --  An integrator is never moved away from what is wanted, by what is
   --  measured. Every actuator and every angle of the laws has the same
   --  sign: more of the output makes more of what is measured.
   function Moves_With (Before, After, Wanted, Measured : Number)
                        return Boolean
   is
     ((if Measured <= Wanted then After >= Before)
      and then (if Measured >= Wanted then After <= Before))
   with Ghost, Global => null;

   procedure Fly_Roll
     (This : in out Memory;
      Was  : Modes;
      Now  : Readings;
      Hand : Sticks;
      By   : Gain_Table)
   with
     Global => null,
     Post   =>
       Flies_Only (Roll_Axis, This'Old, This)
       and then
         (if This.Is_Stick'Old (Roll_Axis)
            and then This.Flown.Lateral = Direct
            and then Hand.Is_Pilot
          then This.Is_Stick (Roll_Axis))
       and then
         (if not This.Is_Stick (Roll_Axis)
          then abs (This.Last.Roll - This.Last'Old.Roll) <= Roll_Step)
       and then
         (if This.Flown.Lateral in Banked
          then abs This.Last.Roll <= Integer'Max
                 (Roll_Authority, abs This.Last'Old.Roll - Roll_Step))

       --  The integrator moves towards the bank that is wanted.
       and then
         (if This.Flown.Lateral in Banked and then Was.Lateral in Banked
          then Moves_With
            (This.Roll_Trim'Old, This.Roll_Trim,
             Wanted => This.Bank_Wanted, Measured => Now.Bank));

   procedure Fly_Yaw (This : in out Memory; Now : Readings; Hand : Sticks)
   with
     Global => null,
     Post   =>
       Flies_Only (Yaw_Axis, This'Old, This)
       and then
         (if This.Is_Stick'Old (Yaw_Axis)
            and then This.Flown.Lateral = Direct
            and then Hand.Is_Pilot
          then This.Is_Stick (Yaw_Axis))
       and then
         (if not This.Is_Stick (Yaw_Axis)
          then abs (This.Last.Yaw - This.Last'Old.Yaw) <= Yaw_Step);

   procedure Fly_Pitch
     (This   : in out Memory;
      Was    : Modes;
      Now    : Readings;
      Hand   : Sticks;
      Rising : Number;
      By     : Gain_Table)
   with
     Global => null,
     Pre    => Rising in -30_000 .. 30_000,
     Post   =>
       Flies_Only (Pitch_Axis, This'Old, This)
       and then
         (if This.Is_Stick'Old (Pitch_Axis)
            and then This.Flown.Vertical = Direct
            and then Hand.Is_Pilot
          then This.Is_Stick (Pitch_Axis))
       and then
         (if not This.Is_Stick (Pitch_Axis)
          then abs (This.Last.Pitch - This.Last'Old.Pitch) <= Pitch_Step)
       and then
         (if This.Flown.Vertical in Pitched
          then abs This.Last.Pitch <= Integer'Max
                 (Pitch_Authority, abs This.Last'Old.Pitch - Pitch_Step))

       --  The integrators move towards the pitch and the climb rate that
       --  are wanted.
       and then
         (if This.Flown.Vertical in Pitched and then Was.Vertical in Pitched
          then Moves_With
            (This.Pitch_Trim'Old, This.Pitch_Trim,
             Wanted => This.Pitch_Wanted, Measured => Now.Pitch))
       and then
         (if This.Flown.Vertical = Hold_Altitude
            and then Was.Vertical in Pitched
          then Moves_With
            (This.Height_Trim'Old, This.Height_Trim,
             Wanted   => Wanted_Climb (This.Height_Held, Now),
             Measured => Rising))
       and then
         (if This.Flown.Vertical = Hold_Altitude
            and then Was.Vertical = Hold_Altitude
          then This.Height_Held = This.Height_Held'Old);

   procedure Fly_Throttle
     (This : in out Memory;
      Was  : Modes;
      Now  : Readings;
      Hand : Sticks)
   with
     Global => null,
     Post   =>
       Flies_Only (Throttle_Axis, This'Old, This)
       and then
         (if This.Is_Stick'Old (Throttle_Axis)
            and then This.Flown.Power = Direct
            and then Hand.Is_Pilot
          then This.Is_Stick (Throttle_Axis))
       and then
         (if not This.Is_Stick (Throttle_Axis)
          then abs (This.Last.Throttle - This.Last'Old.Throttle) <=
                 Throttle_Step)

       --  The integrator moves towards the airspeed that is wanted.
       and then
         (if This.Flown.Power = Hold_Airspeed
            and then Was.Power = Hold_Airspeed
          then This.Speed_Held = This.Speed_Held'Old
            and then This.Lever_Held = This.Lever_Held'Old
            and then Moves_With
              (This.Power_Trim'Old, This.Power_Trim,
               Wanted   => Held_Speed
                 (This.Speed_Held, Hand.Throttle - This.Lever_Held),
               Measured => Now.Airspeed));

   --  All four, and nothing else.
   procedure Fly
     (This   : in out Memory;
      Was    : Modes;
      Now    : Readings;
      Hand   : Sticks;
      Rising : Number;
      By     : Gain_Table)
   with
     Global => null,
     Pre    => Rising in -30_000 .. 30_000,
     Post   =>
       Decides_The_Same (This'Old, This)
       and then
         (if Is_All_Stick (This'Old)
            and then This.Flown = All_Direct
            and then Hand.Is_Pilot
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
                 (Pitch_Authority, abs This.Last'Old.Pitch - Pitch_Step));

   procedure Fly_Roll
     (This : in out Memory;
      Was  : Modes;
      Now  : Readings;
      Hand : Sticks;
      By   : Gain_Table)
   is
      Target : Demand;
      Wanted : Unlimited;
      Aim    : Reckoned := 0;
   begin
      case This.Flown.Lateral is
         when Direct =>
            Wanted := Hand.Roll;
            Target := Hand.Roll;
         when Damping =>
            Target := Plus (Hand.Roll, Roll_Damping_Of (Now));
            Wanted := Target;
         when Banked =>
            if Was.Lateral not in Banked then
               This.Bank_Wanted := Reckoned_Of (Now.Bank);
               This.Roll_Trim := 0;
            end if;
            Aim :=
              (case This.Flown.Lateral is
                  when Bank_By_Stick => Stick_Bank (Hand.Roll),
                  when Orbit         => Orbit_Bank_At (Now.Airspeed),
                  when others        => 0);
            This.Bank_Wanted := Stepped (This.Bank_Wanted, Aim, Bank_Slew);
            Wanted := Unlimited_Roll
              (This.Bank_Wanted, Now, This.Roll_Trim, By.For_Bank);
            Target := Within (Wanted, -Roll_Authority, Roll_Authority);
      end case;

      This.Is_Stick (Roll_Axis) := Is_Stick_Again
        (This.Is_Stick (Roll_Axis), This.Flown.Lateral = Direct,
         Hand.Is_Pilot, This.Last.Roll, Hand.Roll);
      This.Last.Roll :=
        (if This.Is_Stick (Roll_Axis) then Hand.Roll
         else Stepped (This.Last.Roll, Target, Roll_Step));

      if This.Flown.Lateral in Banked then
         This.Roll_Trim := Next_Roll_Trim
           (This.Roll_Trim, Bank_Error (This.Bank_Wanted, Now),
            Saturation_Of (Wanted, -Roll_Authority, Roll_Authority)
              or On_The_Way (This.Bank_Wanted, Aim),
            By.Bank_Learning);
      end if;
   end Fly_Roll;

   procedure Fly_Yaw (This : in out Memory; Now : Readings; Hand : Sticks) is
      Is_Direct : constant Boolean :=
        This.Flown.Lateral = Direct or else not Can_Damp_Yaw (This.Checks);
      Target    : constant Demand :=
        (if Is_Direct then Hand.Yaw
         else Plus (Hand.Yaw, Yaw_Damping_Of (Now)));
   begin
      This.Is_Stick (Yaw_Axis) := Is_Stick_Again
        (This.Is_Stick (Yaw_Axis), Is_Direct, Hand.Is_Pilot, This.Last.Yaw,
         Hand.Yaw);
      This.Last.Yaw :=
        (if This.Is_Stick (Yaw_Axis) then Hand.Yaw
         else Stepped (This.Last.Yaw, Target, Yaw_Step));
   end Fly_Yaw;

   procedure Fly_Pitch
     (This   : in out Memory;
      Was    : Modes;
      Now    : Readings;
      Hand   : Sticks;
      Rising : Number;
      By     : Gain_Table)
   is
      Target : Demand;
      Wanted : Unlimited;
      Output : Saturation;

      --  Where the mode would have the nose, and the highest that it may be.
      Aim     : Unlimited := Level_Pitch;
      Ceiling : Nose      := Highest_Pitch;
      Bounded : Nose      := Level_Pitch;
   begin
      case This.Flown.Vertical is
         when Direct =>
            Wanted := Hand.Pitch;
            Target := Hand.Pitch;
         when Damping =>
            Target := Plus (Hand.Pitch, Pitch_Damping_Of (Now));
            Wanted := Target;
         when Pitched =>
            if Was.Vertical not in Pitched then
               This.Pitch_Wanted := As_Nose (Now.Pitch);
               This.Height_Trim := 0;
               This.Pitch_Trim :=
                 Within
                   (This.Last.Pitch, -First_Pitch_Trim, First_Pitch_Trim)
                 * 1_000;
            end if;
            if Was.Vertical /= Hold_Altitude then
               This.Height_Held := Now.Altitude;
            end if;
            case This.Flown.Vertical is
               when Hold_Altitude =>
                  Aim := Unlimited_Nose
                    (Wanted_Climb (This.Height_Held, Now), Rising, Now.Bank,
                     This.Height_Trim);
               when Glide =>
                  Aim :=
                    (if This.Checks (Airspeed).Is_Valid
                     then Glide_Nose (Now.Airspeed) else Glide_Pitch);
               when others =>
                  Aim := Stick_Nose (Hand.Pitch);
            end case;
            Ceiling :=
              (if This.Checks (Airspeed).Is_Valid
               then Guard (Now.Airspeed) else Highest_Pitch);
            Bounded := Within (Aim, Lowest_Pitch, Ceiling);
            This.Pitch_Wanted :=
              Stepped (This.Pitch_Wanted, Bounded, Pitch_Slew);
            Wanted := Unlimited_Pitch
              (This.Pitch_Wanted, Now, This.Pitch_Trim, By.For_Pitch);
            Target := Within (Wanted, -Pitch_Authority, Pitch_Authority);
      end case;

      This.Is_Stick (Pitch_Axis) := Is_Stick_Again
        (This.Is_Stick (Pitch_Axis), This.Flown.Vertical = Direct,
         Hand.Is_Pilot, This.Last.Pitch, Hand.Pitch);
      This.Last.Pitch :=
        (if This.Is_Stick (Pitch_Axis) then Hand.Pitch
         else Stepped (This.Last.Pitch, Target, Pitch_Step));

      if This.Flown.Vertical in Pitched then
         Output := Saturation_Of (Wanted, -Pitch_Authority, Pitch_Authority);
         if This.Flown.Vertical = Hold_Altitude then
            This.Height_Trim := Next_Height_Trim
              (This.Height_Trim,
               Wanted_Climb (This.Height_Held, Now) - Rising,
               Saturation_Of (Aim, Lowest_Pitch, Ceiling) or Output);
         end if;
         This.Pitch_Trim := Next_Pitch_Trim
           (This.Pitch_Trim, Pitch_Error (This.Pitch_Wanted, Now),
            Output or On_The_Way (This.Pitch_Wanted, Bounded),
            By.Pitch_Learning);
      end if;
   end Fly_Pitch;

   procedure Fly_Throttle
     (This : in out Memory;
      Was  : Modes;
      Now  : Readings;
      Hand : Sticks)
   is
      Target : Lever;
      Wanted : Unlimited;
   begin
      case This.Flown.Power is
         when Direct =>
            Wanted := Hand.Throttle;
            Target := Hand.Throttle;
         when Idle =>
            Wanted := 0;
            Target := 0;
         when Hold_Airspeed =>
            if Was.Power /= Hold_Airspeed then
               This.Speed_Held := Now.Airspeed;
               This.Lever_Held := Hand.Throttle;
               This.Power_Trim := This.Last.Throttle * 1_000;
            end if;
            Wanted := Unlimited_Throttle
              (Held_Speed (This.Speed_Held, Hand.Throttle - This.Lever_Held),
               Now,
               (if This.Flown.Vertical = Hold_Altitude
                then Wanted_Climb (This.Height_Held, Now) else 0),
               This.Power_Trim);
            Target := Within (Wanted, 0, Lever'Last);
      end case;

      This.Is_Stick (Throttle_Axis) := Is_Stick_Again
        (This.Is_Stick (Throttle_Axis), This.Flown.Power = Direct,
         Hand.Is_Pilot, This.Last.Throttle, Hand.Throttle);
      This.Last.Throttle :=
        (if This.Is_Stick (Throttle_Axis) then Hand.Throttle
         else Stepped (This.Last.Throttle, Target, Throttle_Step));

      if This.Flown.Power = Hold_Airspeed then
         This.Power_Trim := Next_Power_Trim
           (This.Power_Trim,
            Held_Speed (This.Speed_Held, Hand.Throttle - This.Lever_Held)
              - Now.Airspeed,
            Saturation_Of (Wanted, 0, Lever'Last));
      end if;
   end Fly_Throttle;

   procedure Fly
     (This   : in out Memory;
      Was    : Modes;
      Now    : Readings;
      Hand   : Sticks;
      Rising : Number;
      By     : Gain_Table) is
   begin
      Fly_Roll (This, Was, Now, Hand, By);
      Fly_Yaw (This, Now, Hand);
      Fly_Pitch (This, Was, Now, Hand, Rising, By);
      Fly_Throttle (This, Was, Now, Hand);
   end Fly;

   function Next
     (This     : Memory;
      Commands : Uplink_Buffer;
      Sensors  : Downlink_Buffer;
      By       : Times;
      Table    : Table_Number := 0) return Memory
   is
      Checks : constant Check_Table :=
        Sensor_Checks.Next (This.Checks, Sensors);
      Heard  : constant Uplink_Buffer :=
        (if Is_Old (Commands) then This.Heard else Commands);
      After  : Memory := This;
      Now    : Readings;
      Hand   : Sticks;
      Rising : Number;
   begin
      After.Link := Link_Loss.Next
        (This.Link, not Is_Old (Commands), Is_On (Commands (Switch_7)), By);
      After.Heard := Heard;
      After.Checks := Checks;
      Now := Readings_Of (Checks);
      if not This.Checks (Altitude).Is_Valid then
         After.Smoothed := Now.Altitude * 1_000;
      end if;
      Rising := Climb_Rate (After.Smoothed, Now.Altitude);
      After.Smoothed := Next_Smooth (After.Smoothed, Now.Altitude);
      if After.Link.State not in Lost then
         After.Is_Flying := not Is_On_Ground (Checks);
      end if;

      After.Flown :=
        (if Is_Disconnected (Commands) then All_Direct
         else Allowed
           (Wanted (After.Link.State, Heard, After.Is_Flying), Checks));

      --  Above all else.
      if Is_Disconnected (Commands) or else After.Link.State = Waiting then
         After.Is_Stick := (Axis => True);
         Hand := Sticks_Of (Heard, Linked);
      else
         Hand := Sticks_Of (Heard, After.Link.State);
      end if;

      Fly (After, This.Flown, Now, Hand, Rising, Gains_Of (Table));
      return After;
   end Next;

end URV.Laws;
