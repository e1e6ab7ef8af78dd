--  SPDX-License-Identifier: Apache-2.0

with Ada.Numerics.Long_Elementary_Functions;

package body Sim.Flight_Quality is

   use type Pilot.Leg_Kind;

   --  The limits of a level end.
   Level_Bank     : constant Long_Float := 3.0;    --  deg
   Level_Climb    : constant Long_Float := 3.0;    --  ft/s
   Level_Altitude : constant Long_Float := 30.0;   --  ft

   Second : constant Long_Float :=
     1_000.0 * Long_Float (Microseconds_Per_Millisecond);

   --  A deviation's root mean square needs the sum until the end.
   type Tally is record
      Observed : Natural    := 0;
      Squares  : Long_Float := 0.0;
      Largest  : Long_Float := 0.0;
   end record;

   type Observations is record
      Any               : Boolean := False;
      First, Last       : Flight_State;
      Wanted            : Pilot.Targets;
      Altitude          : Tally;
      Airspeed          : Tally;
      Bank              : Tally;
      Altitude_In_Turns : Tally;
      Least_Bank        : Long_Float := 0.0;
      Most_Bank         : Long_Float := 0.0;
      Highest_Gain      : Long_Float := 0.0;
      Crash_Time        : Microseconds := 0;
   end record;

   Seen : Observations;

   procedure Add (To : in out Tally; Error : Long_Float);

   function Deviation_Of (Sums : Tally) return Deviation is
     (if Sums.Observed = 0 then (others => <>)
      else
        (Is_Known => True,
         RMS      =>
           Ada.Numerics.Long_Elementary_Functions.Sqrt
             (Sums.Squares / Long_Float (Sums.Observed)),
         Largest  => Sums.Largest));

   --  The same direction, from -180 up to 180 degrees.
   function Nearest (Heading : Long_Float) return Long_Float is
     (Heading - 360.0 * Long_Float'Floor ((Heading + 180.0) / 360.0));

   procedure Add (To : in out Tally; Error : Long_Float) is
   begin
      To.Observed := To.Observed + 1;
      To.Squares  := To.Squares + Error * Error;
      To.Largest  := Long_Float'Max (To.Largest, abs Error);
   end Add;

   procedure Start is
   begin
      Seen := (others => <>);
   end Start;

   procedure Observe
     (Time   : Microseconds;
      Truth  : Flight_State;
      Wanted : Pilot.Targets)
   is
      Too_High : constant Long_Float := Truth.Altitude - Wanted.Altitude;
   begin
      if not Seen.Any then
         Seen.Any   := True;
         Seen.First := Truth;
      end if;
      if Truth.Crashed and then not Seen.Last.Crashed then
         Seen.Crash_Time := Time;
      end if;
      Seen.Last   := Truth;
      Seen.Wanted := Wanted;

      case Wanted.Kind is
         when Pilot.Hold =>
            Add (Seen.Altitude, Too_High);
            Add (Seen.Airspeed, Truth.Airspeed - Wanted.Airspeed);
            Add (Seen.Bank, Truth.Bank - Wanted.Bank);
         when Pilot.Turn =>
            Add (Seen.Altitude_In_Turns, Too_High);
         when Pilot.Climb | Pilot.Flap_Change =>
            null;
      end case;

      Seen.Least_Bank := Long_Float'Min (Seen.Least_Bank, Truth.Bank);
      Seen.Most_Bank  := Long_Float'Max (Seen.Most_Bank, Truth.Bank);
      Seen.Highest_Gain :=
        Long_Float'Max
          (Seen.Highest_Gain, Truth.Altitude - Seen.First.Altitude);
   end Observe;

   function Result return Quality is
      Now    : Flight_State renames Seen.Last;
      Wanted : Pilot.Targets renames Seen.Wanted;
   begin
      return
        (Altitude          => Deviation_Of (Seen.Altitude),
         Airspeed          => Deviation_Of (Seen.Airspeed),
         Bank              => Deviation_Of (Seen.Bank),
         Altitude_In_Turns => Deviation_Of (Seen.Altitude_In_Turns),
         Steepest_Left     => -Seen.Least_Bank,
         Steepest_Right    => Seen.Most_Bank,
         Highest_Gain      => Seen.Highest_Gain,
         Altitude_Error    => Now.Altitude - Wanted.Altitude,
         Airspeed_Error    => Now.Airspeed - Wanted.Airspeed,
         Bank_Error        => Now.Bank - Wanted.Bank,
         Heading_Error     =>
           Nearest (Now.Heading - Seen.First.Heading - Wanted.Heading),
         Ended_Level       =>
           Seen.Any
           and then Wanted.Kind = Pilot.Hold
           and then not Now.Crashed
           and then abs Now.Bank < Level_Bank
           and then abs Now.Climb < Level_Climb
           and then abs (Now.Altitude - Wanted.Altitude) < Level_Altitude,
         Crashed           => Now.Crashed,
         Crash_Time        => Seen.Crash_Time);
   end Result;

   procedure Report (To : in out Summary.Result) is

      procedure Add (Name : String; Value : Long_Float);
      procedure Add (Name : String; Value : Boolean);
      procedure Add (Item, Unit : String; Value : Deviation);

      procedure Add (Name : String; Value : Long_Float) is
      begin
         Summary.Add_Quality (To, Name, Value);
      end Add;

      procedure Add (Name : String; Value : Boolean) is
      begin
         Summary.Add_Quality (To, Name, Value);
      end Add;

      procedure Add (Item, Unit : String; Value : Deviation) is
      begin
         if Value.Is_Known then
            Add (Item & "_rms_" & Unit, Value.RMS);
            Add (Item & "_max_" & Unit, Value.Largest);
         else
            Summary.Add_Unknown_Quality (To, Item & "_rms_" & Unit);
            Summary.Add_Unknown_Quality (To, Item & "_max_" & Unit);
         end if;
      end Add;

      Flown : constant Quality := Result;

   begin
      Add ("altitude", "ft", Flown.Altitude);
      Add ("airspeed", "kt", Flown.Airspeed);
      Add ("bank", "deg", Flown.Bank);
      Add ("turn_altitude", "ft", Flown.Altitude_In_Turns);
      Add ("bank_left_deg", Flown.Steepest_Left);
      Add ("bank_right_deg", Flown.Steepest_Right);
      Add ("climb_ft", Flown.Highest_Gain);
      Add ("final_altitude_error_ft", Flown.Altitude_Error);
      Add ("final_airspeed_error_kt", Flown.Airspeed_Error);
      Add ("final_bank_error_deg", Flown.Bank_Error);
      Add ("final_heading_error_deg", Flown.Heading_Error);
      Add ("ended_level", Flown.Ended_Level);
      Add ("crashed", Flown.Crashed);
      if Flown.Crashed then
         Add
           ("crashed_at_s", Long_Float (Flown.Crash_Time) / Second);
      end if;
   end Report;

end Sim.Flight_Quality;
