--  SPDX-License-Identifier: Apache-2.0

with Host.Pilot.Circuits;

package body Host.Pilot.Flights is

   Second : constant Microseconds := 1_000 * Microseconds_Per_Millisecond;

   --  A leg lasts until the next one starts.
   type Leg is record
      Start      : Microseconds;
      Kind       : Leg_Kind;
      Altitude   : Long_Float;
      Heading    : Long_Float;
      Flaps_Down : Boolean := False;
   end record;

   type Leg_List is array (Positive range <>) of Leg;

   Cruise_Speed : constant Long_Float := 70.0;
   Low          : constant Long_Float := 1_000.0;
   High         : constant Long_Float := 1_300.0;

   --  A target altitude moves at this rate, 720 ft/min.
   Climb_Per_Second : constant Long_Float := 12.0;

   Bank_In_Turns : constant Long_Float := 25.0;

   Standard_Length : constant Microseconds := 180 * Second;
   Standard_Legs   : constant Leg_List :=
     ((0 * Second,   Hold,  Low,  0.0, False),
      (15 * Second,  Turn,  Low,  -90.0, False),
      (40 * Second,  Hold,  Low,  -90.0, False),
      (45 * Second,  Turn,  Low,  0.0, False),
      (70 * Second,  Hold,  Low,  0.0, False),
      (75 * Second,  Climb, High, 0.0, False),
      (107 * Second, Hold,  High, 0.0, False),
      (112 * Second, Climb, Low,  0.0, False),
      (144 * Second, Hold,  Low,  0.0, False),
      (148 * Second, Flap_Change, Low, 0.0, True),
      (158 * Second, Hold,  Low,  0.0, True),
      (162 * Second, Flap_Change, Low, 0.0, False),
      (172 * Second, Hold,  Low,  0.0, False));

   Level_Length : constant Microseconds := 60 * Second;
   Level_Legs   : constant Leg_List :=
     (1 => (0 * Second, Hold, Low, 0.0, False));

   function Targets_In (Legs : Leg_List; Time : Microseconds) return Targets;

   --  The part of that change completed after some seconds.
   function Changed (Change, Seconds : Long_Float) return Long_Float is
     (Long_Float'Max
        (-Climb_Per_Second * Seconds,
         Long_Float'Min (Climb_Per_Second * Seconds, Change)));

   --  Most in the direction of a change, zero without one.
   function Towards (Change, Most : Long_Float) return Long_Float is
     (if Change > 0.0 then Most elsif Change < 0.0 then -Most else 0.0);

   function Length (Of_Flight : Flight) return Microseconds is
     (case Of_Flight is
         when Standard_Flight => Standard_Length,
         when Level_Flight    => Level_Length,
         when Flight_By_Eye   => Circuits.Length);

   function Targets_At (Of_Flight : Flight; Time : Microseconds)
                        return Targets
   is (case Of_Flight is
          when Standard_Flight => Targets_In (Standard_Legs, Time),
          when Level_Flight    => Targets_In (Level_Legs, Time),
          when Flight_By_Eye   => (others => <>));

   function Targets_In (Legs : Leg_List; Time : Microseconds) return Targets
   is
      Index : Positive := Legs'First;
   begin
      while Index < Legs'Last and then Time >= Legs (Index + 1).Start loop
         Index := Index + 1;
      end loop;

      declare
         Now     : Leg renames Legs (Index);
         Before  : Leg renames Legs (Positive'Max (Index - 1, Legs'First));
         Seconds : constant Long_Float :=
           Long_Float (Time - Now.Start) / Long_Float (Second);
         Higher  : constant Long_Float := Now.Altitude - Before.Altitude;
         Climbed : constant Long_Float := Changed (Higher, Seconds);
      begin
         return
           (Kind       => Now.Kind,
            Altitude   => Before.Altitude + Climbed,
            Climb      => Towards (Higher - Climbed, Climb_Per_Second),
            Airspeed   => Cruise_Speed,
            Bank       =>
              Towards (Now.Heading - Before.Heading, Bank_In_Turns),
            Heading    => Now.Heading,
            Flaps_Down => Now.Flaps_Down);
      end;
   end Targets_In;

end Host.Pilot.Flights;
