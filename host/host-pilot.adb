--  SPDX-License-Identifier: Apache-2.0

with Host.Pilot.Circuits;
with Host.Pilot.Flights;  use Host.Pilot.Flights;
with Host.Pilot.Readings; use Host.Pilot.Readings;
with Host.Scaling;        use Host.Scaling;

package body Host.Pilot is

   --  The time between two moves, in seconds.
   Interval : constant Long_Float :=
     Long_Float (Major_Frame) / Long_Float (Microseconds_Per_Second);

   --  Sticks are in per cent of their travel.
   Stick_Limit : constant Long_Float := 60.0;

   --  The positions of the levers that the pilot does not move.
   Cruise_Throttle : constant Long_Float := 50.0;
   Cruise_Pitch    : constant Long_Float := 2.4;

   --  Bank per degree of heading, its limit, and its rate of change.
   Bank_Per_Heading : constant Long_Float := 1.0;
   Steepest_Bank    : constant Long_Float := 25.0;
   Bank_Slew        : constant Long_Float := 12.0;   --  deg/s

   --  Roll stick.
   Roll_Per_Bank      : constant Long_Float := 1.1;
   Roll_Per_Rate      : constant Long_Float := 0.10;
   Roll_Integral_Gain : constant Long_Float := 0.25;    --  a second
   Roll_Trim_Most     : constant Long_Float := 10.0;

   --  The trim does not learn while a turn begins or ends.
   Roll_Learning_Range : constant Long_Float := 3.0;   --  deg

   --  Yaw stick: the pedals follow the sideslip slowly.
   Yaw_Integral_Gain  : constant Long_Float := 1.0;
   Yaw_Trim_Most      : constant Long_Float := 20.0;

   --  Target pitch attitude: from the altitude through a climb rate.
   Climb_Per_Altitude   : constant Long_Float := 0.25;   --  a second
   Fastest_Climb        : constant Long_Float := 16.0;   --  ft/s
   Pitch_Per_Climb      : constant Long_Float := 0.50;   --  deg per ft/s
   Pitch_Per_Lag        : constant Long_Float := 0.25;   --  deg per ft/s
   Pitch_Integral_Gain  : constant Long_Float := 0.02;   --  a second
   Pitch_Learning_Range : constant Long_Float := 10.0;   --  ft
   Pitch_Trim_Most     : constant Long_Float := 4.0;

   --  More alpha in a turn, less with flaps.
   Pitch_In_Turns      : constant Long_Float := 6.3;
   Pitch_Per_Flap      : constant Long_Float := -0.24;

   --  Pitch stick.
   Stick_Per_Pitch         : constant Long_Float := 1.7;
   Stick_Per_Rate          : constant Long_Float := 0.6;
   Stick_Integral_Gain     : constant Long_Float := 1.0;
   Stick_Trim_Most         : constant Long_Float := 20.0;
   Stick_In_Turns          : constant Long_Float := 30.0;
   Stick_Per_Flap          : constant Long_Float := -0.40;

   --  Throttle.
   Throttle_Per_Speed      : constant Long_Float := 6.0;
   Throttle_Integral_Gain  : constant Long_Float := 0.6;
   Throttle_Trim_Most      : constant Long_Float := 30.0;
   Throttle_Per_Climb      : constant Long_Float := 3.0;
   Throttle_Per_Flap       : constant Long_Float := 0.9;

   --  Displays that stay unchanged for this many moves mean a lost link.
   Longest_Unchanged : constant := 10;

   --  The pilot's memory from move to move. The trims are the stick positions
   --  that hold every target.
   type Memory is record
      Flown          : Flight          := Flight'First;
      Wanted         : Targets;
      Has_Seen       : Boolean         := False;
      Seen           : Downlink_Buffer := Neutral_Downlink;
      Unchanged      : Natural         := 0;
      Stale          : Natural         := 0;
      Heading        : Long_Float      := 0.0;
      Bank_Wanted    : Long_Float      := 0.0;
      Roll_Trim      : Long_Float      := 0.0;
      Yaw_Trim       : Long_Float      := 0.0;
      Pitch_Trim     : Long_Float      := 0.0;
      Stick_Trim     : Long_Float      := 0.0;
      Throttle_Trim  : Long_Float      := 0.0;
      View           : Pilot.View;
      View_Is_New    : Boolean         := False;
   end record;

   State : Memory;

   --  The five levers, in per cent.
   type Levers is record
      Roll, Pitch, Yaw : Long_Float := 0.0;
      Throttle         : Long_Float := Cruise_Throttle;
   end record;

   Controls : Levers;

   function Named (Name : String) return Flight
     with Pre => Exists (Name);

   function Names_From (First : Flight; By_Eye : Boolean) return String;

   function Bounded (Value, Most : Long_Float) return Long_Float is
     (Long_Float'Max (-Most, Long_Float'Min (Most, Value)));

   --  Adds a second's error to a trim, unless the data are old.
   procedure Integrate
     (Trim : in out Long_Float; Per_Second, Most : Long_Float);

   procedure Look (Downlink : Downlink_Buffer);

   procedure Fly_Lateral (Now : Reading);
   procedure Fly_Vertical (Now : Reading);

   --  Moves the sticks to the trims: the aircraft is stable.
   procedure Let_Go;

   function On_Console return Console_Words;

   function Is_Old return Boolean is
     (State.Stale > 0 or else State.Unchanged > Longest_Unchanged);

   function Exists (Name : String) return Boolean is
     (for some Known in Flight => Flights.Name (Known) = Name);

   function Names_From (First : Flight; By_Eye : Boolean) return String is
     (Flights.Name (First)
      & (if First = Flight'Last
           or else (not By_Eye and then Flight'Succ (First) in Flight_By_Eye)
         then ""
         else ", " & Names_From (Flight'Succ (First), By_Eye)));

   function Names (By_Eye : Boolean := True) return String is
     (Names_From (Flight'First, By_Eye));

   function Named (Name : String) return Flight is
   begin
      for Known in Flight loop
         if Flights.Name (Known) = Name then
            return Known;
         end if;
      end loop;
      raise Program_Error with "no such flight";
   end Named;

   function Is_By_Eye (Name : String) return Boolean is
     (Named (Name) in Flight_By_Eye);

   function Length (Name : String) return Microseconds is
     (Flights.Length (Named (Name)));

   procedure Start (Name : String) is
   begin
      State    := (Flown => Named (Name), others => <>);
      Controls := (others => <>);
      Circuits.Start;
   end Start;

   procedure See (Now : View) is
   begin
      State.View        := Now;
      State.View_Is_New := True;
   end See;

   function Present_Targets return Targets is (State.Wanted);

   procedure Integrate
     (Trim : in out Long_Float; Per_Second, Most : Long_Float) is
   begin
      if not Is_Old then
         Trim := Bounded (Trim + Per_Second * Interval, Most);
      end if;
   end Integrate;

   procedure Look (Downlink : Downlink_Buffer) is
   begin
      --  The word's other bits are independent of its age (TST-4).
      if (Downlink (Error_Status) and Stale_Data) /= 0 then
         State.Stale := State.Stale + 1;
      else
         State.Stale := 0;
      end if;
      if Downlink = State.Seen then
         State.Unchanged := State.Unchanged + 1;
      else
         State.Unchanged := 0;
      end if;
      State.Seen := Downlink;
      if not State.Has_Seen and then State.Stale = 0 then
         State.Has_Seen := Is_Flying (Read (Downlink));
      end if;
   end Look;

   procedure Fly_Lateral (Now : Reading) is
      Turn : constant Long_Float :=
        Bounded
          (Bank_Per_Heading * (State.Wanted.Heading - State.Heading),
           Steepest_Bank);
      Lag  : Long_Float;
   begin
      State.Bank_Wanted :=
        State.Bank_Wanted
        + Bounded (Turn - State.Bank_Wanted, Bank_Slew * Interval);
      Lag := State.Bank_Wanted - Now.Bank;
      if abs Lag < Roll_Learning_Range then
         Integrate (State.Roll_Trim, Roll_Integral_Gain * Lag, Roll_Trim_Most);
      end if;
      Controls.Roll :=
        Roll_Per_Bank * Lag - Roll_Per_Rate * Now.Roll_Rate
        + State.Roll_Trim;

      Integrate (State.Yaw_Trim, Yaw_Integral_Gain * Now.Beta, Yaw_Trim_Most);
      Controls.Yaw := State.Yaw_Trim;
   end Fly_Lateral;

   procedure Fly_Vertical (Now : Reading) is
      --  The additional lift for a turn: 1 / cos (bank) - 1.
      Extra : constant Long_Float :=
        1.0 / Long_Float'Max (0.5, Cosine (Now.Bank)) - 1.0;
      Below : constant Long_Float := State.Wanted.Altitude - Now.Altitude;
      Climb : constant Long_Float :=
        Bounded
          (State.Wanted.Climb + Climb_Per_Altitude * Below, Fastest_Climb);
      Slow  : constant Long_Float := State.Wanted.Airspeed - Now.Airspeed;
      Pitch : Long_Float;
   begin
      Integrate
        (State.Pitch_Trim,
         Pitch_Integral_Gain * Bounded (Below, Pitch_Learning_Range),
         Pitch_Trim_Most);
      Pitch :=
        Cruise_Pitch + State.Pitch_Trim
        + Pitch_Per_Climb * Climb
        + Pitch_Per_Lag * (Climb - Climb_Rate (Now))
        + Pitch_In_Turns * Extra
        + Pitch_Per_Flap * Now.Flaps;

      Integrate
        (State.Stick_Trim, Stick_Integral_Gain * (Pitch - Now.Pitch),
         Stick_Trim_Most);
      Controls.Pitch :=
        Stick_Per_Pitch * (Pitch - Now.Pitch)
        - Stick_Per_Rate
          * (Now.Pitch_Rate - Turn_Rate (Now) * Sine (Now.Bank))
        + State.Stick_Trim
        + Stick_In_Turns * Extra
        + Stick_Per_Flap * Now.Flaps;

      Integrate
        (State.Throttle_Trim, Throttle_Integral_Gain * Slow,
         Throttle_Trim_Most);
      Controls.Throttle :=
        Cruise_Throttle + State.Throttle_Trim
        + Throttle_Per_Speed * Slow
        + Throttle_Per_Climb * Climb
        + Throttle_Per_Flap * Now.Flaps;
   end Fly_Vertical;

   procedure Let_Go is
   begin
      Controls :=
        (Roll     => State.Roll_Trim,
         Pitch    => State.Stick_Trim,
         Yaw      => State.Yaw_Trim,
         Throttle => Cruise_Throttle + State.Throttle_Trim);
   end Let_Go;

   function On_Console return Console_Words is

      function Stick (Percent : Long_Float) return Word is
        (To_Word (Bounded (Percent, Stick_Limit), Deflection));

   begin
      return Console : Console_Words := Neutral_Console do
         Console (Roll)     := Stick (Controls.Roll);
         Console (Pitch)    := Stick (Controls.Pitch);
         Console (Yaw)      := Stick (Controls.Yaw);
         Console (Throttle) := To_Word (Controls.Throttle, Lever);
         if State.Wanted.Flaps_Down then
            Console (Switch_8) := Converter_Value'Last;
         end if;
      end return;
   end On_Console;

   procedure Move
     (Time     : Microseconds;
      Downlink : Downlink_Buffer;
      Console  : out Console_Words)
   is
      Now : constant Reading := Read (Downlink);
   begin
      State.Wanted := Targets_At (State.Flown, Time);
      Look (Downlink);
      if State.Flown in Flight_By_Eye then
         Circuits.Move
           (Now, State.Stale > 0, State.View, State.View_Is_New, Console);
         State.View_Is_New := False;
         if State.Flown = Damped_Circuit_Flight then
            Console (Switch_1) := Converter_Value'Last;
         end if;
         return;
      end if;
      if State.Has_Seen then
         State.Heading := State.Heading + Turn_Rate (Now) * Interval;
         if State.Stale > Longest_Unchanged then
            Let_Go;
         else
            Fly_Lateral (Now);
            Fly_Vertical (Now);
         end if;
      end if;
      Console := On_Console;
   end Move;

   procedure Watch (Downlink : Downlink_Buffer) is
      Now : constant Reading := Read (Downlink);
   begin
      Look (Downlink);
      if State.Has_Seen then
         State.Heading := State.Heading + Turn_Rate (Now) * Interval;
         State.Bank_Wanted := Now.Bank;
      end if;
   end Watch;

end Host.Pilot;
