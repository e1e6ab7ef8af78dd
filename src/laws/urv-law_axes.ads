--  SPDX-License-Identifier: Apache-2.0

--  The control laws' arithmetic, one axis at a time (EXT-3, EXT-8, D-31).
--
--  Each law computes a target for its output from the measurements. The output
--  moves to the target within its rate limit. URV.Integrators says when an
--  integrator moves, and in which direction.

with URV.Integrators; use URV.Integrators;
with URV.Law_Gains;   use URV.Law_Gains;
with URV.Law_Units;   use URV.Law_Units;

package URV.Law_Axes with Pure, SPARK_Mode is

   --  The sensors' values.
   type Readings is record
      Bank, Pitch                    : Angle;
      Roll_Rate, Pitch_Rate, Yaw_Rate : Rate;
      Altitude, Airspeed             : Level;
   end record;

   --  Integrators
   subtype Roll_Trim is Number range -Roll_Trim_Most .. Roll_Trim_Most;
   subtype Pitch_Trim is Number range -Pitch_Trim_Most .. Pitch_Trim_Most;
   subtype Height_Trim is Number range -Height_Trim_Most .. Height_Trim_Most;
   subtype Power_Trim is Number range 0 .. Lever'Last * 1_000;

   --  A measured climb rate, thousandths of a foot a second.
   subtype Climb_Reading is Number range -30_000 .. 30_000;

   --  The filtered altitude, thousandths of half a foot.
   subtype Smooth is Number range 0 .. Level'Last * 1_000;

   subtype Bank_Command is Number range -Largest_Bank .. Largest_Bank;
   subtype Pitch_Command is Number range Lowest_Pitch .. Highest_Pitch;
   subtype Climb is Number range -Most_Climb .. Most_Climb;

   --  The output that a law computes before limits. The part beyond the limits
   --  of its target is saturation.
   subtype Unlimited is Number range -200_000 .. 200_000;

   --  Bank, limited to the laws' range, and the rates and load of a level turn
   --  with it

   function As_Bank_Command (Bank : Angle) return Bank_Command is
     (Within (Bank, -Largest_Bank, Largest_Bank))
   with Global => null;

   function Turn_Rate (Bank : Angle) return Rate is
     (As_Bank_Command (Bank) / Per_Ten * Turn_For_Bank / 1_000)
   with Global => null;

   subtype Square is Number range 0 .. 360_000;

   function Squared (Bank : Angle) return Square is
     ((abs As_Bank_Command (Bank) / Tenths)
      * (abs As_Bank_Command (Bank) / Tenths))
   with Global => null;

   function Turn_Pitch_Rate (Bank : Angle) return Rate is
     (Squared (Bank) / Square_Per_Rate)
   with Global => null;

   subtype Load is Number range 0 .. 1_000;

   function Extra_Load (Bank : Angle) return Load is
     (Squared (Bank) / Square_Per_Load)
   with Global => null;

   --  Rate damping: a demand against the rate, within its authority

   subtype Damping is Number range -Damping_Authority .. Damping_Authority;

   function Damped (Turning : Number; Gain : Number) return Damping is
     (Within
        (-(Turning * Gain / Per_Thousand),
         -Damping_Authority, Damping_Authority))
   with
     Global => null,
     Pre    => Turning in -250_000 .. 250_000 and then Gain in 0 .. 100;

   function Roll_Damping_Of (Now : Readings) return Damping is
     (Damped (Now.Roll_Rate, Roll_Damping))
   with Global => null;

   function Pitch_Damping_Of (Now : Readings) return Damping is
     (Damped (Now.Pitch_Rate - Turn_Pitch_Rate (Now.Bank), Pitch_Damping))
   with Global => null;

   function Yaw_Damping_Of (Now : Readings) return Damping is
     (Damped (Now.Yaw_Rate - Turn_Rate (Now.Bank), Yaw_Damping))
   with Global => null;

   --  A stick's demand plus damping.
   function Plus (Stick : Demand; Extra : Damping) return Demand is
     (Within (Stick + Extra, Demand'First, Demand'Last))
   with Global => null;

   --  Bank: the reference moves to the wanted bank, and the ailerons follow it

   function Bank_Error (Reference : Bank_Command; Now : Readings)
                        return Number
   is
     (Within (Reference - Now.Bank, -Largest_Bank, Largest_Bank))
   with
     Global => null,
     Post   =>
       Bank_Error'Result in -Largest_Bank .. Largest_Bank
       and then (Bank_Error'Result > 0) = (Now.Bank < Reference)
       and then (Bank_Error'Result < 0) = (Now.Bank > Reference);

   function Unlimited_Roll
     (Reference : Bank_Command; Now : Readings; Trim : Roll_Trim; By : Gain)
      return Unlimited
   is
     (Bank_Error (Reference, Now) * By / Per_Thousand
      - Now.Roll_Rate * Roll_Damping / Per_Thousand
      + Trim / 1_000)
   with Global => null;

   function Stick_Bank (Stick : Demand) return Bank_Command is
     (Stick * (Most_Bank / 8) / 256)
   with Global => null;

   --  The bank for a right turn at 3 deg/s.
   function Orbit_Bank_At (Airspeed : Level) return Bank_Command is
     (Within (Airspeed, Least_Speed, Orbit_Fastest) * Orbit_Bank / 100)
   with Global => null;

   --  Pitch, in the same way as bank

   function Pitch_Error (Reference : Pitch_Command; Now : Readings)
                         return Number
   is
     (Within (Reference - Now.Pitch, -Largest_Bank, Largest_Bank))
   with
     Global => null,
     Post   =>
       Pitch_Error'Result in -Largest_Bank .. Largest_Bank
       and then (Pitch_Error'Result > 0) = (Now.Pitch < Reference)
       and then (Pitch_Error'Result < 0) = (Now.Pitch > Reference);

   function Unlimited_Pitch
     (Reference : Pitch_Command; Now : Readings; Trim : Pitch_Trim; By : Gain)
      return Unlimited
   is
     (Pitch_Error (Reference, Now) * By / Per_Thousand
      - (Now.Pitch_Rate - Turn_Pitch_Rate (Now.Bank))
        * Pitch_Damping / Per_Thousand
      + Extra_Load (Now.Bank) * Stick_For_Load / Per_Ten
      + Trim / 1_000)
   with Global => null;

   function As_Pitch_Command (Pitch : Number) return Pitch_Command is
     (Within (Pitch, Lowest_Pitch, Highest_Pitch))
   with Global => null;

   function Stick_Pitch_Command (Stick : Demand) return Pitch_Command is
     (As_Pitch_Command (Level_Pitch + Stick * (Stick_Pitch / 16) / 128))
   with Global => null;

   --  The glide, with a valid airspeed

   function Glide_Pitch_Command (Airspeed : Level) return Pitch_Command is
     (As_Pitch_Command (Glide_Pitch + (Airspeed - Glide_Speed) * Glide_Gain))
   with Global => null;

   --  Altitude

   function Wanted_Climb (Target : Level; Now : Readings) return Climb is
     (Within
        ((Target - Now.Altitude) * Climb_Gain, -Most_Climb, Most_Climb))
   with
     Global => null,
     Post   =>
       (if Target > Now.Altitude then Wanted_Climb'Result > 0
        elsif Target < Now.Altitude then Wanted_Climb'Result < 0
        else Wanted_Climb'Result = 0);

   function Next_Smooth (Item : Smooth; Now : Level) return Smooth is
     (Item + (Now * 1_000 - Item) / Filter_Frames)
   with Global => null;

   function Climb_Rate (Item : Smooth; Now : Level) return Number is
     (Within (Now * 1_000 - Item, -30_000, 30_000))
   with
     Global => null,
     Post   => Climb_Rate'Result in -30_000 .. 30_000;

   --  The pitch that the altitude law demands, before limits.
   function Unlimited_Pitch_Command
     (Wanted : Climb;
      Rising : Number;
      Bank   : Angle;
      Trim   : Height_Trim) return Unlimited
   is
     (Level_Pitch + Trim / Per_Ten
      + Wanted * Pitch_For_Climb / Per_Hundred
      + (Wanted - Rising) * Pitch_For_Lag / Per_Hundred
      + Extra_Load (Bank) * Pitch_For_Load / Per_Ten)
   with
     Global => null,
     Pre    => Rising in -30_000 .. 30_000;

   --  The upper limit of pitch that protects the airspeed

   function Guard (Airspeed : Level) return Pitch_Command is
     (As_Pitch_Command
        (Highest_Pitch + (Airspeed - Guarded_Speed) * Guard_Gain))
   with Global => null;

   --  Throttle

   function Held_Speed (Airspeed : Level; Moved : Number) return Level is
     (Within
        (Airspeed + Moved * Speed_For_Lever / Per_Ten,
         Least_Speed, Most_Speed))
   with
     Global => null,
     Pre    => Moved in -4_095 .. 4_095;

   function Unlimited_Throttle
     (Target : Level; Now : Readings; Wanted : Climb; Trim : Power_Trim)
      return Unlimited
   is
     ((Target - Now.Airspeed) * Speed_Gain
      + Wanted * Speed_For_Climb / 1_000
      + Trim / 1_000)
   with Global => null;

   --  Integrators: each moves with the sign of its error, unless its output is
   --  saturated in that direction. Each postcondition gives the least error
   --  that moves it.

   function Next_Roll_Trim
     (Trim : Roll_Trim; Error : Number; Output : Saturation; By : Gain)
      return Roll_Trim
   is
     (Integrated
        (Trim, Error_Share (Error, Roll_Integrated, By, Per_Angle), Output,
         -Roll_Trim_Most, Roll_Trim_Most))
   with
     Global => null,
     Pre    => Error in -Largest_Bank .. Largest_Bank,
     Post   =>
       Follows (Trim, Next_Roll_Trim'Result, Error, Output)
       and then
         (if Moves (Error, By, Per_Angle) and then not Output.Is_High
            and then Error > 0 and then Trim < Roll_Trim'Last
          then Next_Roll_Trim'Result > Trim)
       and then
         (if Moves (Error, By, Per_Angle) and then not Output.Is_Low
            and then Error < 0 and then Trim > Roll_Trim'First
          then Next_Roll_Trim'Result < Trim);

   function Next_Pitch_Trim
     (Trim : Pitch_Trim; Error : Number; Output : Saturation; By : Gain)
      return Pitch_Trim
   is
     (Integrated
        (Trim, Error_Share (Error, Pitch_Integrated, By, Per_Angle), Output,
         -Pitch_Trim_Most, Pitch_Trim_Most))
   with
     Global => null,
     Pre    => Error in -Largest_Bank .. Largest_Bank,
     Post   =>
       Follows (Trim, Next_Pitch_Trim'Result, Error, Output)
       and then
         (if Moves (Error, By, Per_Angle) and then not Output.Is_High
            and then Error > 0 and then Trim < Pitch_Trim'Last
          then Next_Pitch_Trim'Result > Trim)
       and then
         (if Moves (Error, By, Per_Angle) and then not Output.Is_Low
            and then Error < 0 and then Trim > Pitch_Trim'First
          then Next_Pitch_Trim'Result < Trim);

   --  Its error is the wanted climb rate minus the measured one. With the
   --  altitude error as input it would wind up throughout a large change of
   --  altitude.
   function Next_Height_Trim
     (Trim : Height_Trim; Error : Number; Output : Saturation)
      return Height_Trim
   is
     (Integrated
        (Trim,
         Error_Share
           (Error, Height_Integrated, Height_Integral_Gain, Per_Climb),
         Output, -Height_Trim_Most, Height_Trim_Most))
   with
     Global => null,
     Pre    => Error in -40_000 .. 40_000,
     Post   =>
       Follows (Trim, Next_Height_Trim'Result, Error, Output)
       and then
         (if Moves (Error, Height_Integral_Gain, Per_Climb)
            and then not Output.Is_High
            and then Error > 0 and then Trim < Height_Trim'Last
          then Next_Height_Trim'Result > Trim)
       and then
         (if Moves (Error, Height_Integral_Gain, Per_Climb)
            and then not Output.Is_Low
            and then Error < 0 and then Trim > Height_Trim'First
          then Next_Height_Trim'Result < Trim);

   function Next_Power_Trim
     (Trim : Power_Trim; Error : Number; Output : Saturation)
      return Power_Trim
   is
     (Integrated
        (Trim,
         Error_Share (Error, Level'Last, Speed_Integral_Gain, Per_Speed),
         Output,
         0, Power_Trim'Last))
   with
     Global => null,
     Pre    => Error in -4_095 .. 4_095,
     Post   =>
       Follows (Trim, Next_Power_Trim'Result, Error, Output)
       and then
         (if Error > 0 and then not Output.Is_High
            and then Trim < Power_Trim'Last
          then Next_Power_Trim'Result > Trim)
       and then
         (if Error < 0 and then not Output.Is_Low
            and then Trim > Power_Trim'First
          then Next_Power_Trim'Result < Trim);

end URV.Law_Axes;
