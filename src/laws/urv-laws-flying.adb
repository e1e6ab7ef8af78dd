--  SPDX-License-Identifier: Apache-2.0

package body URV.Laws.Flying with SPARK_Mode is

   procedure Fly_Roll
     (This  : in out Memory;
      Was   : Modes;
      Now   : Readings;
      Input : Sticks;
      By    : Gain_Table;
      Added : Increment)
   is
      Target : Demand;
      Wanted : Unlimited;
      Aim    : Bank_Command := 0;
   begin
      case This.Flown.Lateral is
         when Direct =>
            Wanted := Input.Roll;
            Target := Input.Roll;
         when Damping =>
            Target := Plus (Input.Roll, Roll_Damping_Of (Now));
            Wanted := Target;
         when Banked =>
            if Was.Lateral not in Banked then
               This.Bank_Wanted := As_Bank_Command (Now.Bank);
               This.Roll_Trim := 0;
            end if;
            Aim :=
              Moved_Bank
                ((case This.Flown.Lateral is
                     when Bank_By_Stick => Stick_Bank (Input.Roll),
                     when Orbit         => Orbit_Bank_At (Now.Airspeed),
                     when others        => 0),
                 Added);
            This.Bank_Wanted := Stepped (This.Bank_Wanted, Aim, Bank_Slew);
            Wanted := Unlimited_Roll
              (This.Bank_Wanted, Now, This.Roll_Trim, By.For_Bank);
            Target := Within (Wanted, -Roll_Authority, Roll_Authority);
      end case;

      This.Is_Stick (Roll_Axis) := Is_Stick_Again
        (This.Is_Stick (Roll_Axis), This.Flown.Lateral = Direct,
         Input.Is_Pilot, This.Last.Roll, Input.Roll, Roll_Step);
      This.Last.Roll :=
        (if This.Is_Stick (Roll_Axis) then Input.Roll
         else Stepped (This.Last.Roll, Target, Roll_Step));

      if This.Flown.Lateral in Banked then
         This.Roll_Trim := Next_Roll_Trim
           (This.Roll_Trim, Bank_Error (This.Bank_Wanted, Now),
            Saturation_Of (Wanted, -Roll_Authority, Roll_Authority)
              or On_The_Way (This.Bank_Wanted, Aim),
            By.Bank_Integral_Gain);
      end if;
   end Fly_Roll;

   procedure Fly_Yaw (This : in out Memory; Now : Readings; Input : Sticks) is
      Is_Direct : constant Boolean :=
        This.Flown.Lateral = Direct or else not Can_Damp_Yaw (This.Checks);
      Target    : constant Demand :=
        (if Is_Direct then Input.Yaw
         else Plus (Input.Yaw, Yaw_Damping_Of (Now)));
   begin
      This.Is_Stick (Yaw_Axis) := Is_Stick_Again
        (This.Is_Stick (Yaw_Axis), Is_Direct, Input.Is_Pilot, This.Last.Yaw,
         Input.Yaw, Yaw_Step);
      This.Last.Yaw :=
        (if This.Is_Stick (Yaw_Axis) then Input.Yaw
         else Stepped (This.Last.Yaw, Target, Yaw_Step));
   end Fly_Yaw;

   procedure Fly_Pitch
     (This   : in out Memory;
      Was    : Modes;
      Now    : Readings;
      Input  : Sticks;
      Rising : Climb_Reading;
      By     : Gain_Table;
      Extra  : Command_Inputs)
   is
      Target : Demand;
      Wanted : Unlimited;
      Output : Saturation;

      --  The pitch that the mode demands, and its upper limit.
      Aim     : Unlimited     := Level_Pitch;
      Ceiling : Pitch_Command := Highest_Pitch;
      Bounded : Pitch_Command := Level_Pitch;

      --  The climb rate that the altitude demands.
      Rate    : Climb         := 0;
   begin
      case This.Flown.Vertical is
         when Direct =>
            Wanted := Input.Pitch;
            Target := Input.Pitch;
         when Damping =>
            Target := Plus (Input.Pitch, Pitch_Damping_Of (Now));
            Wanted := Target;
         when Pitched =>
            if Was.Vertical not in Pitched then
               This.Pitch_Wanted := As_Pitch_Command (Now.Pitch);
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
                  Rate := Wanted_Climb
                    (Moved_Height (This.Height_Held, Extra.Altitude), Now);
                  Aim := Unlimited_Pitch_Command
                    (Rate, Rising, Now.Bank, This.Height_Trim);
               when Glide =>
                  Aim :=
                    (if This.Checks (Airspeed).Is_Valid
                     then Glide_Pitch_Command (Now.Airspeed) else Glide_Pitch);
               when others =>
                  Aim := Stick_Pitch_Command (Input.Pitch);
            end case;
            Aim := Moved_Pitch (Aim, Extra.Pitch);
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
         Input.Is_Pilot, This.Last.Pitch, Input.Pitch, Pitch_Step);
      This.Last.Pitch :=
        (if This.Is_Stick (Pitch_Axis) then Input.Pitch
         else Stepped (This.Last.Pitch, Target, Pitch_Step));

      if This.Flown.Vertical in Pitched then
         Output := Saturation_Of (Wanted, -Pitch_Authority, Pitch_Authority);
         if This.Flown.Vertical = Hold_Altitude then
            This.Height_Trim := Next_Height_Trim
              (This.Height_Trim, Rate - Rising,
               Saturation_Of (Aim, Lowest_Pitch, Ceiling) or Output);
         end if;
         This.Pitch_Trim := Next_Pitch_Trim
           (This.Pitch_Trim, Pitch_Error (This.Pitch_Wanted, Now),
            Output or On_The_Way (This.Pitch_Wanted, Bounded),
            By.Pitch_Integral_Gain);
      end if;
   end Fly_Pitch;

   procedure Fly_Throttle
     (This  : in out Memory;
      Was   : Modes;
      Now   : Readings;
      Input : Sticks;
      Extra : Command_Inputs)
   is
      Target : Lever;
      Wanted : Unlimited;

      --  The airspeed that is demanded.
      Speed  : Level := 0;
   begin
      case This.Flown.Power is
         when Direct =>
            Wanted := Input.Throttle;
            Target := Input.Throttle;
         when Idle =>
            Wanted := 0;
            Target := 0;
         when Hold_Airspeed =>
            if Was.Power /= Hold_Airspeed then
               This.Speed_Held := Now.Airspeed;
               This.Lever_Held := Input.Throttle;
               This.Power_Trim := This.Last.Throttle * 1_000;
            end if;
            Speed := Demanded_Speed (This, Input.Throttle, Extra.Airspeed);
            Wanted := Unlimited_Throttle
              (Speed, Now,
               (if This.Flown.Vertical = Hold_Altitude
                then Wanted_Climb
                  (Moved_Height (This.Height_Held, Extra.Altitude), Now)
                else 0),
               This.Power_Trim);
            Target := Within (Wanted, 0, Lever'Last);
      end case;

      This.Is_Stick (Throttle_Axis) := Is_Stick_Again
        (This.Is_Stick (Throttle_Axis), This.Flown.Power = Direct,
         Input.Is_Pilot, This.Last.Throttle, Input.Throttle,
         Throttle_Step);
      This.Last.Throttle :=
        (if This.Is_Stick (Throttle_Axis) then Input.Throttle
         else Stepped (This.Last.Throttle, Target, Throttle_Step));

      if This.Flown.Power = Hold_Airspeed then
         This.Power_Trim := Next_Power_Trim
           (This.Power_Trim, Speed - Now.Airspeed,
            Saturation_Of (Wanted, 0, Lever'Last));
      end if;
   end Fly_Throttle;

   procedure Fly
     (This   : in out Memory;
      Was    : Modes;
      Now    : Readings;
      Input  : Sticks;
      Rising : Climb_Reading;
      By     : Gain_Table;
      Extra  : Command_Inputs) is
   begin
      Fly_Roll (This, Was, Now, Input, By, Extra.Bank);
      Fly_Yaw (This, Now, Input);
      Fly_Pitch (This, Was, Now, Input, Rising, By, Extra);
      Fly_Throttle (This, Was, Now, Input, Extra);
   end Fly;

end URV.Laws.Flying;
