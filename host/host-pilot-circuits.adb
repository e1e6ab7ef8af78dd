--  SPDX-License-Identifier: Apache-2.0

with Host.Pilot.Pictures; use Host.Pilot.Pictures;
with Host.Runway;
with Host.Scaling;        use Host.Scaling;

package body Host.Pilot.Circuits is

   Interval : constant Long_Float :=
     Long_Float (Major_Frame) / Long_Float (Microseconds_Per_Second);

   type Phase is
     (Ready, Take_Off, Climb_Out, Crosswind_Leg, Downwind_Leg, Base_Leg,
      Final_Leg, Flare, Roll_Out);
   subtype On_The_Ground is Phase with
     Static_Predicate => On_The_Ground in Ready | Take_Off | Roll_Out;

   --  The circuit, in ft from its beginning.
   Circuit_Height  : constant Long_Float := 400.0;
   First_Turn_East : constant Long_Float := 2_400.0;
   Downwind_North  : constant Long_Float := 2_000.0;
   Base_East       : constant Long_Float := -4_600.0;
   Lead            : constant Long_Float := 800.0;   --  ft before a turn

   --  The approach path ends here, and would touch the ground.
   Aim_East    : constant Long_Float := 250.0;
   Path_Slope  : constant Long_Float := 0.079;
   Flare_Below : constant Long_Float := 25.0;   --  ft

   --  Below this height the sink rate stays constant.
   Held_Off    : constant Long_Float := 1.5;

   --  The pilot's knowledge of the aircraft.
   Circuit_Speed  : constant Long_Float := 65.0;   --  kt
   Base_Speed     : constant Long_Float := 60.0;
   Approach_Speed : constant Long_Float := 56.0;
   Landing_Speed  : constant Long_Float := 51.0;
   Lift_Off_Speed : constant Long_Float := 50.0;
   Lift_Off_Pitch : constant Long_Float := 8.0;    --  deg
   Highest_Climb  : constant Long_Float := 11.0;   --  ft/s
   Touch_Sink     : constant Long_Float := 1.2;    --  ft/s
   Stick_Limit    : constant Long_Float := 95.0;   --  per cent

   --  The pilot's memory from move to move.
   type Memory is record
      Doing         : Phase := Ready;
      Moves         : Natural := 0;     --  in this phase
      Picture       : Pictures.Picture;
      Bank_Wanted   : Long_Float := 0.0;
      Roll_Trim     : Long_Float := 0.0;
      Yaw_Trim      : Long_Float := 0.0;
      Path_Trim     : Long_Float := 0.0;   --  deg of pitch
      Stick_Trim    : Long_Float := 0.0;
      Throttle_Trim : Long_Float := 0.0;
      Flare_Sink    : Long_Float := 0.0;
      Aligned       : Long_Float := 0.0;   --  0 with the air, 1 the runway
      Low_Moves     : Natural    := 0;     --  consecutive
      Nose          : Long_Float := 0.0;   --  deg, target of lowering it
   end record;

   State : Memory;

   --  In per cent.
   type Levers is record
      Roll, Pitch, Yaw : Long_Float := 0.0;
      Throttle         : Long_Float := 0.0;
      Brake            : Long_Float := 100.0;
      Flaps_Down       : Boolean := False;
   end record;

   Controls : Levers;

   function Bounded (Value, Most : Long_Float) return Long_Float is
     (Long_Float'Max (-Most, Long_Float'Min (Most, Value)));

   function Nearest (Angle : Long_Float) return Long_Float is
     (Angle - 360.0 * Long_Float'Floor ((Angle + 180.0) / 360.0));

   Degrees_Per_Radian : constant Long_Float := 57.295_779_5;

   procedure Integrate
     (Trim : in out Long_Float; Per_Second, Most : Long_Float);

   procedure Go_On_To (Next : Phase);

   --  Decides whether this phase is over.
   procedure Decide (Now : Reading);

   --  The bank that follows a line with a course, or turns towards it.
   function Bank_For
     (Course, Right_Of_Line : Long_Float) return Long_Float;

   --  The bank that keeps the aircraft over the centre line.
   function Bank_Over_Runway (Now : Reading) return Long_Float;

   procedure Bank_To (Wanted : Long_Float; Now : Reading);

   --  The nose points into the air stream or, when aligned, along the runway.
   procedure Fly_Yaw (Now : Reading);

   --  Pitch for a climb rate, throttle for a speed. An increasing climb rate
   --  needs more lift, as a share of the weight.
   procedure Fly_Path
     (Climb, Speed : Long_Float;
      Now          : Reading;
      Rounding     : Long_Float := 0.0);
   procedure Pitch_To (Wanted : Long_Float; Now : Reading);
   procedure Push_Throttle (Climb, Speed : Long_Float; Now : Reading);

   procedure Steer (Now : Reading);

   --  The moves of each phase.
   procedure Roll_Off (Now : Reading);
   procedure Fly_Round (Now : Reading);
   procedure Approach (Now : Reading);
   procedure Touch_Down (Now : Reading);
   procedure Brake (Now : Reading);

   function On_Console return Console_Words;

   function Path_Height return Long_Float is
     ((Aim_East - State.Picture.East) * Path_Slope);

   procedure Integrate
     (Trim : in out Long_Float; Per_Second, Most : Long_Float) is
   begin
      Trim := Bounded (Trim + Per_Second * Interval, Most);
   end Integrate;

   procedure Go_On_To (Next : Phase) is
   begin
      State.Doing := Next;
      State.Moves := 0;
   end Go_On_To;

   procedure Start is
   begin
      State    := (others => <>);
      Controls := (others => <>);
      Pictures.Start (State.Picture);
   end Start;

   procedure Decide (Now : Reading) is
      Here : Picture renames State.Picture;
   begin
      State.Moves := State.Moves + 1;
      case State.Doing is
         when Ready =>
            if State.Moves > 150 then
               Go_On_To (Take_Off);
            end if;
         when Take_Off =>
            if Here.Height > 4.0 and then Here.Climb > 1.0 then
               State.Stick_Trim := 0.0;
               Go_On_To (Climb_Out);
            end if;
         when Climb_Out =>
            if Here.East > First_Turn_East and then Here.Height > 200.0 then
               Go_On_To (Crosswind_Leg);
            end if;
         when Crosswind_Leg =>
            if Here.North > Downwind_North - Lead then
               Go_On_To (Downwind_Leg);
            end if;
         when Downwind_Leg =>
            if Here.East < Base_East + Lead then
               Go_On_To (Base_Leg);
            end if;
         when Base_Leg =>
            if Here.North < Lead then
               Go_On_To (Final_Leg);
            end if;
         when Final_Leg =>
            if Here.Height < Flare_Below then
               State.Flare_Sink :=
                 Long_Float'Max (4.0, Long_Float'Min (9.0, -Here.Climb));
               Go_On_To (Flare);
            end if;
         when Flare =>
            --  The wheels stay on the ground.
            State.Low_Moves :=
              (if Here.Height < 0.5 and then abs Here.Climb < 0.5
               then State.Low_Moves + 1 else 0);
            if State.Low_Moves > 15 then
               State.Nose := Now.Pitch;
               Go_On_To (Roll_Out);
            end if;
         when Roll_Out =>
            --  A gust has lifted the aircraft again.
            if (Here.Height > 1.2 or else Here.Climb < -1.5)
              and then State.Moves < 50
            then
               State.Low_Moves := 0;
               Go_On_To (Flare);
            end if;
      end case;
   end Decide;

   function Bank_For
     (Course, Right_Of_Line : Long_Float) return Long_Float
   is
      Per_Foot   : constant Long_Float :=
        (if State.Doing = Final_Leg and then State.Picture.Height < 150.0
         then 0.2 else 0.08);
      Per_Degree : constant Long_Float :=
        (if State.Doing = Final_Leg then 1.4 else 1.0);
      Here  : Picture renames State.Picture;
      Angle : constant Long_Float := Nearest (Course);

      --  The wind component to the right of the course, for four courses.
      Wind  : constant Long_Float :=
        (if abs Angle < 45.0 then Here.Wind_East
         elsif abs Angle > 135.0 then -Here.Wind_East
         elsif Angle > 0.0 then -Here.Wind_North
         else Here.Wind_North);
      Drift : constant Long_Float :=
        Degrees_Per_Radian * Wind / Long_Float'Max (60.0, Here.Speed);
      Nose  : constant Long_Float :=
        Course - Bounded (Per_Foot * Right_Of_Line, 40.0) - Drift;
   begin
      return
        Bounded (Per_Degree * Nearest (Nose - Here.Heading), 25.0);
   end Bank_For;

   function Bank_Over_Runway (Now : Reading) return Long_Float is
      Here : Picture renames State.Picture;
   begin
      --  North is left of the line; a bank into the slip holds it.
      return
        Bounded
          (0.45 * Here.North + 1.5 * Here.North_Speed
           + 0.34 * State.Aligned * Now.Beta,
           Long_Float'Min (15.0, 9.0 + 0.4 * Here.Height));
   end Bank_Over_Runway;

   procedure Bank_To (Wanted : Long_Float; Now : Reading) is
      Slower : constant Long_Float :=
        Long_Float'Min (2.0, (70.0 / Long_Float'Max (45.0, Now.Airspeed)));
      Lag    : Long_Float;

      --  In a slip, and on the ground, a crosswind lifts a wing.
      Slip   : constant Long_Float :=
        (if State.Doing not in On_The_Ground then State.Aligned
         elsif Now.Airspeed > 20.0 then 1.0
         else 0.0);
   begin
      State.Bank_Wanted :=
        State.Bank_Wanted
        + Bounded (Wanted - State.Bank_Wanted, 15.0 * Interval);
      Lag := State.Bank_Wanted - Now.Bank;
      if abs Lag < 3.0 then
         Integrate (State.Roll_Trim, 0.4 * Lag, 15.0);
      end if;
      Controls.Roll :=
        Slower * (2.0 * Lag - 0.15 * Now.Roll_Rate) + State.Roll_Trim
        + 4.2 * Slip * Bounded (Now.Beta, 20.0);
   end Bank_To;

   procedure Fly_Yaw (Now : Reading) is
      Askew : constant Long_Float :=
        Nearest (Runway.Heading - State.Picture.Heading);
   begin
      Integrate
        (State.Yaw_Trim,
         (1.0 - State.Aligned) * Now.Beta
         + 0.8 * State.Aligned * Bounded (Askew, 5.0),
         20.0);
      Controls.Yaw :=
        State.Yaw_Trim
        + State.Aligned
          * (1.8 * Askew - 0.8 * State.Picture.Turn - 4.4 * Now.Beta);
   end Fly_Yaw;

   procedure Fly_Path
     (Climb, Speed : Long_Float;
      Now          : Reading;
      Rounding     : Long_Float := 0.0)
   is
      Fast  : constant Long_Float :=
        Long_Float'Max (60.0, State.Picture.Speed);

      --  Lift over pressure and area, in radians of alpha.
      Lift  : constant Long_Float :=
        200.0 * (1.0 + Rounding) / (24.0 * 0.001_16 * Fast * Fast)
        / Long_Float'Max (0.7, Cosine (Now.Bank));
      Alpha : constant Long_Float :=
        Bounded
          ((Degrees_Per_Radian * (Lift - 0.3) - 1.15 * Now.Flaps) / 4.8,
           11.0);
      Lag   : constant Long_Float :=
        Degrees_Per_Radian * (Climb - State.Picture.Climb) / Fast;

      --  The pilot feels a gust before it moves the aircraft.
      Load  : constant Long_Float :=
        Now.Load * Cosine (Now.Bank) * Cosine (Now.Pitch);
      Lead  : constant Long_Float :=
        (if State.Doing = Flare then 8.0 else 0.0);

      --  Near the ground it matters more.
      Share    : constant Long_Float :=
        (if State.Doing = Flare then 1.5 else 0.6);
      Integral_Gain : constant Long_Float :=
        (if State.Doing = Flare then 0.5 else 0.2);
   begin
      Integrate (State.Path_Trim, Integral_Gain * Bounded (Lag, 3.0), 5.0);
      Pitch_To
        (Bounded
           (Alpha + Degrees_Per_Radian * Climb / Fast + Share * Lag
            - Lead * (Load - 1.0 - Rounding) + State.Path_Trim,
            14.0),
         Now);
      Push_Throttle (Climb, Speed, Now);
   end Fly_Path;

   procedure Pitch_To (Wanted : Long_Float; Now : Reading) is
      Weaker : constant Long_Float :=
        (70.0 / Long_Float'Max (45.0, Now.Airspeed)) ** 2;
      Extra  : constant Long_Float :=
        1.0 / Long_Float'Max (0.5, Cosine (Now.Bank)) - 1.0;
   begin
      Integrate (State.Stick_Trim, 1.2 * (Wanted - Now.Pitch), 35.0);
      Controls.Pitch :=
        Weaker
        * (1.7 * (Wanted - Now.Pitch)
           - 0.6 * (Now.Pitch_Rate - Turn_Rate (Now) * Sine (Now.Bank)))
        + State.Stick_Trim + 30.0 * Extra;
   end Pitch_To;

   procedure Push_Throttle (Climb, Speed : Long_Float; Now : Reading) is
      Slow : constant Long_Float := Speed - Now.Airspeed;
   begin
      if Controls.Throttle > 1.0 and then Controls.Throttle < 99.0 then
         Integrate (State.Throttle_Trim, 0.6 * Slow, 30.0);
      end if;
      Controls.Throttle :=
        Long_Float'Max
          (0.0,
           Long_Float'Min
             (100.0,
              45.0 + State.Throttle_Trim + 5.0 * Slow + 3.0 * Climb
              + 0.9 * Now.Flaps));
   end Push_Throttle;

   procedure Steer (Now : Reading) is
      Here   : Picture renames State.Picture;
      Fast   : constant Long_Float := Long_Float'Max (12.0, Here.Speed);

      --  Returns to the line within some seconds, then follows it.
      Nose   : constant Long_Float :=
        Bounded (Degrees_Per_Radian * 0.25 * Here.North / Fast, 5.0);
      Askew  : constant Long_Float :=
        Nearest (Runway.Heading + Nose - Here.Heading);

      --  A wheel base of 3.3 ft, and 0.1024 degrees a per cent.
      Per_Turn : constant Long_Float := 3.33 / Fast / 0.102_4;

      --  The crosswind correction at speed.
      By_Air   : constant Long_Float :=
        Long_Float'Max
          (0.0, Long_Float'Min (1.0, (Now.Airspeed - 15.0) / 20.0));
   begin
      --  While the nose comes down the rudders keep their deflection.
      State.Aligned :=
        Long_Float'Max (0.0, State.Aligned - 0.5 * Interval);
      Integrate (State.Yaw_Trim, 0.5 * Bounded (Askew, 5.0), 15.0);
      Controls.Yaw :=
        Bounded
          ((1.0 + 0.5 * Per_Turn) * Askew - 0.7 * Here.Turn
           + State.Yaw_Trim
           - By_Air * (1.6 + 2.6 * State.Aligned) * Bounded (Now.Beta, 20.0),
           70.0);
      Bank_To (0.0, Now);
   end Steer;

   procedure Roll_Off (Now : Reading) is
   begin
      Controls.Brake := 0.0;
      Controls.Throttle :=
        Long_Float'Min (100.0, Controls.Throttle + 40.0 * Interval);
      Steer (Now);
      if Now.Airspeed > Lift_Off_Speed then
         Pitch_To (Lift_Off_Pitch, Now);
      else
         Controls.Pitch := 0.0;
      end if;
   end Roll_Off;

   procedure Fly_Round (Now : Reading) is
      Here  : Picture renames State.Picture;
      Speed : constant Long_Float :=
        (if State.Doing = Base_Leg then Base_Speed else Circuit_Speed);

      --  Speed has priority over climb.
      Fast  : constant Long_Float :=
        Long_Float'Max (2.0, Highest_Climb + Now.Airspeed - (Speed - 6.0));
      Climb : constant Long_Float :=
        Long_Float'Max
          (-8.0,
           Long_Float'Min
             (Long_Float'Min (Fast, Highest_Climb),
              0.25 * (Circuit_Height - Here.Height)));
   begin
      State.Aligned := 0.0;
      Controls.Flaps_Down := State.Doing = Base_Leg;
      Fly_Path (Climb, Speed, Now);
      Fly_Yaw (Now);
      Bank_To
        ((case State.Doing is
             when Climb_Out     =>
                Bank_For (Runway.Heading, -Here.North),
             when Crosswind_Leg => Bank_For (0.0, 0.0),
             when Downwind_Leg  =>
                Bank_For (-90.0, Here.North - Downwind_North),
             when others        => Bank_For (180.0, 0.0)),
         Now);
   end Fly_Round;

   procedure Approach (Now : Reading) is
      Here  : Picture renames State.Picture;
      Above : constant Long_Float := Path_Height - Here.Height;
      Climb : constant Long_Float :=
        Long_Float'Max
          (-11.0,
           Long_Float'Min
             (2.0,
              (if Path_Height > Circuit_Height
               then 0.25 * (Circuit_Height - Here.Height)
               else -Path_Slope * Here.East_Speed + 0.25 * Above)));
   begin
      Controls.Flaps_Down := True;
      if Here.Height < 60.0 then
         State.Aligned :=
           Long_Float'Min (1.0, State.Aligned + 0.25 * Interval);
         Bank_To (Bank_Over_Runway (Now), Now);
      else
         Bank_To (Bank_For (Runway.Heading, -Here.North), Now);
      end if;
      Fly_Path (Climb, Approach_Speed, Now);
      Fly_Yaw (Now);
   end Approach;

   procedure Touch_Down (Now : Reading) is
      Here  : Picture renames State.Picture;
      Share : constant Long_Float :=
        Long_Float'Max
          (0.0, (Here.Height - Held_Off) / (Flare_Below - Held_Off));
      Sink  : constant Long_Float :=
        Touch_Sink + (State.Flare_Sink - Touch_Sink) * Share;

      --  The rate at which the sink decreases, in weights.
      Rounding : constant Long_Float :=
        (if Share > 0.0
         then Sink * (State.Flare_Sink - Touch_Sink)
              / (Flare_Below - Held_Off) / 32.2
         else 0.0);
   begin
      State.Aligned := Long_Float'Min (1.0, State.Aligned + 0.25 * Interval);
      Bank_To (Bank_Over_Runway (Now), Now);
      Fly_Path
        (-Sink,
         Landing_Speed + (Approach_Speed - Landing_Speed) * Share,
         Now, Rounding);
      Fly_Yaw (Now);
      if Here.Height < 0.8 then
         Controls.Throttle := 0.0;
      end if;
   end Touch_Down;

   procedure Brake (Now : Reading) is
   begin
      Controls.Throttle := 0.0;
      Steer (Now);

      --  The nose comes down by itself and is then held down; without flaps
      --  the wheels carry more weight.
      Controls.Flaps_Down := False;
      State.Nose := Long_Float'Max (-1.0, State.Nose - 6.0 * Interval);
      State.Stick_Trim :=
        Long_Float'Max (-12.0, State.Stick_Trim - 15.0 * Interval);
      Controls.Pitch :=
        State.Stick_Trim + 3.0 * Bounded (State.Nose - Now.Pitch, 5.0)
        - 1.0 * Now.Pitch_Rate;
      if State.Moves > 75 then
         Controls.Brake :=
           Long_Float'Min
             ((if State.Moves > 750 then 100.0 else 40.0),
              Controls.Brake + 25.0 * Interval);
      end if;
   end Brake;

   function On_Console return Console_Words is

      function Stick (Percent : Long_Float) return Word is
        (To_Word (Bounded (Percent, Stick_Limit), Deflection));

   begin
      return Console : Console_Words := Neutral_Console do
         Console (Roll)     := Stick (Controls.Roll);
         Console (Pitch)    := Stick (Controls.Pitch);
         Console (Yaw)      := Stick (Controls.Yaw);
         Console (Throttle) := To_Word (Controls.Throttle, Lever);
         Console (Brake)    := To_Word (Controls.Brake, Pedal);
         if Controls.Flaps_Down then
            Console (Switch_8) := Converter_Value'Last;
         end if;
      end return;
   end On_Console;

   procedure Move
     (Now     : Reading;
      Is_Old  : Boolean;
      Seen    : View;
      Is_New  : Boolean;
      Console : out Console_Words) is
   begin
      if not Is_Old then
         Dead_Reckon
           (State.Picture, Now, On_Wheels => State.Doing in On_The_Ground);
         if Is_New then
            Correct
              (State.Picture, Seen,
               On_Wheels => State.Doing in On_The_Ground);
         end if;
         Decide (Now);
         case State.Doing is
            when Ready     => Set_Zero (State.Picture, Now);
            when Take_Off  => Roll_Off (Now);
            when Final_Leg => Approach (Now);
            when Flare     => Touch_Down (Now);
            when Roll_Out  => Brake (Now);
            when others    => Fly_Round (Now);
         end case;
      end if;
      Console := On_Console;
   end Move;

end Host.Pilot.Circuits;
