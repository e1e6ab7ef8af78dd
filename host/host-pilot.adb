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
   Roll_Per_Bank  : constant Long_Float := 1.1;
   Roll_Per_Rate  : constant Long_Float := 0.10;
   Roll_Learning  : constant Long_Float := 0.25;    --  a second
   Roll_Trim_Most : constant Long_Float := 10.0;

   --  The trim does not learn while a turn begins or ends.
   Roll_Learning_Range : constant Long_Float := 3.0;   --  deg

   --  Yaw stick: the pedals follow the sideslip slowly.
   Yaw_Learning   : constant Long_Float := 1.0;
   Yaw_Trim_Most  : constant Long_Float := 20.0;

   --  Target pitch attitude: from the altitude through a climb rate.
   Climb_Per_Altitude  : constant Long_Float := 0.25;   --  a second
   Fastest_Climb       : constant Long_Float := 16.0;   --  ft/s
   Pitch_Per_Climb     : constant Long_Float := 0.50;   --  deg per ft/s
   Pitch_Per_Lag       : constant Long_Float := 0.25;   --  deg per ft/s
   Pitch_Learning      : constant Long_Float := 0.02;   --  a second
   Pitch_Learning_Range : constant Long_Float := 10.0;   --  ft
   Pitch_Trim_Most     : constant Long_Float := 4.0;

   --  More alpha in a turn, less with flaps.
   Pitch_In_Turns      : constant Long_Float := 6.3;
   Pitch_Per_Flap      : constant Long_Float := -0.24;

   --  Pitch stick.
   Stick_Per_Pitch     : constant Long_Float := 1.7;
   Stick_Per_Rate      : constant Long_Float := 0.6;
   Stick_Learning      : constant Long_Float := 1.0;
   Stick_Trim_Most     : constant Long_Float := 20.0;
   Stick_In_Turns      : constant Long_Float := 30.0;
   Stick_Per_Flap      : constant Long_Float := -0.40;

   --  Throttle.
   Throttle_Per_Speed  : constant Long_Float := 6.0;
   Throttle_Learning   : constant Long_Float := 0.6;
   Throttle_Trim_Most  : constant Long_Float := 30.0;
   Throttle_Per_Climb  : constant Long_Float := 3.0;
   Throttle_Per_Flap   : constant Long_Float := 0.9;

   --  Displays that stay unchanged for this many moves mean a lost link.
   Patience : constant := 10;

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
      Sight          : Pilot.Sight;
      Sight_Is_New   : Boolean         := False;
   end record;

   Mind : Memory;

   --  The five levers, in per cent.
   type Levers is record
      Roll, Pitch, Yaw : Long_Float := 0.0;
      Throttle         : Long_Float := Cruise_Throttle;
   end record;

   Hands : Levers;

   function Named (Name : String) return Flight
     with Pre => Exists (Name);

   function Names_From (First : Flight; By_Eye : Boolean) return String;

   function Bounded (Value, Most : Long_Float) return Long_Float is
     (Long_Float'Max (-Most, Long_Float'Min (Most, Value)));

   --  Adds a second's error to a trim, unless the data are old.
   procedure Learn
     (Trim : in out Long_Float; Per_Second, Most : Long_Float);

   procedure Look (Downlink : Downlink_Buffer);

   procedure Fly_Lateral (Now : Reading);
   procedure Fly_Vertical (Now : Reading);

   --  Moves the sticks to the trims: the aircraft is stable.
   procedure Let_Go;

   function On_Console return Console_Words;

   function Is_Old return Boolean is
     (Mind.Stale > 0 or else Mind.Unchanged > Patience);

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
      Mind  := (Flown => Named (Name), others => <>);
      Hands := (others => <>);
      Circuits.Start;
   end Start;

   procedure See (Now : Sight) is
   begin
      Mind.Sight        := Now;
      Mind.Sight_Is_New := True;
   end See;

   function Present_Targets return Targets is (Mind.Wanted);

   procedure Learn
     (Trim : in out Long_Float; Per_Second, Most : Long_Float) is
   begin
      if not Is_Old then
         Trim := Bounded (Trim + Per_Second * Interval, Most);
      end if;
   end Learn;

   procedure Look (Downlink : Downlink_Buffer) is
   begin
      --  The word's other bits are independent of its age (TST-4).
      if (Downlink (Error_Status) and Stale_Data) /= 0 then
         Mind.Stale := Mind.Stale + 1;
      else
         Mind.Stale := 0;
      end if;
      if Downlink = Mind.Seen then
         Mind.Unchanged := Mind.Unchanged + 1;
      else
         Mind.Unchanged := 0;
      end if;
      Mind.Seen := Downlink;
      if not Mind.Has_Seen and then Mind.Stale = 0 then
         Mind.Has_Seen := Is_Flying (Read (Downlink));
      end if;
   end Look;

   procedure Fly_Lateral (Now : Reading) is
      Turn : constant Long_Float :=
        Bounded
          (Bank_Per_Heading * (Mind.Wanted.Heading - Mind.Heading),
           Steepest_Bank);
      Lag  : Long_Float;
   begin
      Mind.Bank_Wanted :=
        Mind.Bank_Wanted
        + Bounded (Turn - Mind.Bank_Wanted, Bank_Slew * Interval);
      Lag := Mind.Bank_Wanted - Now.Bank;
      if abs Lag < Roll_Learning_Range then
         Learn (Mind.Roll_Trim, Roll_Learning * Lag, Roll_Trim_Most);
      end if;
      Hands.Roll :=
        Roll_Per_Bank * Lag - Roll_Per_Rate * Now.Roll_Rate
        + Mind.Roll_Trim;

      Learn (Mind.Yaw_Trim, Yaw_Learning * Now.Beta, Yaw_Trim_Most);
      Hands.Yaw := Mind.Yaw_Trim;
   end Fly_Lateral;

   procedure Fly_Vertical (Now : Reading) is
      --  The additional lift for a turn: 1 / cos (bank) - 1.
      Extra : constant Long_Float :=
        1.0 / Long_Float'Max (0.5, Cosine (Now.Bank)) - 1.0;
      Below : constant Long_Float := Mind.Wanted.Altitude - Now.Altitude;
      Climb : constant Long_Float :=
        Bounded
          (Mind.Wanted.Climb + Climb_Per_Altitude * Below, Fastest_Climb);
      Slow  : constant Long_Float := Mind.Wanted.Airspeed - Now.Airspeed;
      Pitch : Long_Float;
   begin
      Learn
        (Mind.Pitch_Trim,
         Pitch_Learning * Bounded (Below, Pitch_Learning_Range),
         Pitch_Trim_Most);
      Pitch :=
        Cruise_Pitch + Mind.Pitch_Trim
        + Pitch_Per_Climb * Climb
        + Pitch_Per_Lag * (Climb - Climb_Rate (Now))
        + Pitch_In_Turns * Extra
        + Pitch_Per_Flap * Now.Flaps;

      Learn
        (Mind.Stick_Trim, Stick_Learning * (Pitch - Now.Pitch),
         Stick_Trim_Most);
      Hands.Pitch :=
        Stick_Per_Pitch * (Pitch - Now.Pitch)
        - Stick_Per_Rate
          * (Now.Pitch_Rate - Turn_Rate (Now) * Sine (Now.Bank))
        + Mind.Stick_Trim
        + Stick_In_Turns * Extra
        + Stick_Per_Flap * Now.Flaps;

      Learn
        (Mind.Throttle_Trim, Throttle_Learning * Slow, Throttle_Trim_Most);
      Hands.Throttle :=
        Cruise_Throttle + Mind.Throttle_Trim
        + Throttle_Per_Speed * Slow
        + Throttle_Per_Climb * Climb
        + Throttle_Per_Flap * Now.Flaps;
   end Fly_Vertical;

   procedure Let_Go is
   begin
      Hands :=
        (Roll     => Mind.Roll_Trim,
         Pitch    => Mind.Stick_Trim,
         Yaw      => Mind.Yaw_Trim,
         Throttle => Cruise_Throttle + Mind.Throttle_Trim);
   end Let_Go;

   function On_Console return Console_Words is

      function Stick (Percent : Long_Float) return Word is
        (To_Word (Bounded (Percent, Stick_Limit), Deflection));

   begin
      return Console : Console_Words := Neutral_Console do
         Console (Roll)     := Stick (Hands.Roll);
         Console (Pitch)    := Stick (Hands.Pitch);
         Console (Yaw)      := Stick (Hands.Yaw);
         Console (Throttle) := To_Word (Hands.Throttle, Lever);
         if Mind.Wanted.Flaps_Down then
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
      Mind.Wanted := Targets_At (Mind.Flown, Time);
      Look (Downlink);
      if Mind.Flown in Flight_By_Eye then
         Circuits.Move
           (Now, Mind.Stale > 0, Mind.Sight, Mind.Sight_Is_New, Console);
         Mind.Sight_Is_New := False;
         if Mind.Flown = Damped_Circuit_Flight then
            Console (Switch_1) := Converter_Value'Last;
         end if;
         return;
      end if;
      if Mind.Has_Seen then
         Mind.Heading := Mind.Heading + Turn_Rate (Now) * Interval;
         if Mind.Stale > Patience then
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
      if Mind.Has_Seen then
         Mind.Heading := Mind.Heading + Turn_Rate (Now) * Interval;
         Mind.Bank_Wanted := Now.Bank;
      end if;
   end Watch;

end Host.Pilot;
