--  SPDX-License-Identifier: Apache-2.0

--  The simulated pilot at the console (SIM-3).
--
--  The pilot knows the flight by heart and reads the ground's CORE memory:
--  words that are late, rounded, and sometimes not updated. There is no
--  compass among them; the pilot integrates the rates into a heading. In a
--  circuit the pilot is beside the runway and also sees the aircraft (SIM-7).
--
--  Fifty times a second the sticks move: bank by ailerons, sideslip by
--  rudders, pitch by elevators, speed by throttle. The arithmetic is plain, so
--  that the same words always give the same sticks.

package Host.Pilot is

   --  The purpose of a part of a flight. Only in a hold must every value stay
   --  at its target.
   type Leg_Kind is (Hold, Turn, Climb, Flap_Change);

   --  The pilot's present targets.
   type Targets is record
      Kind       : Leg_Kind   := Hold;
      Altitude   : Long_Float := 0.0;     --  ft above the field
      Climb      : Long_Float := 0.0;     --  ft/s, of that altitude
      Airspeed   : Long_Float := 0.0;     --  kt
      Bank       : Long_Float := 0.0;     --  deg, that of a turn under way
      Heading    : Long_Float := 0.0;     --  deg right of the first heading
      Flaps_Down : Boolean    := False;   --  half flaps, by switch 8
   end record;

   --  The aircraft as seen from beside the runway: its position relative to
   --  its place at the beginning, in ft, and its heading, in deg.
   type View is record
      North, East : Long_Float := 0.0;
      Heading     : Long_Float := 0.0;
   end record;

   --  The names of the flights, in a list for people; or only of those that
   --  the displays suffice for.
   function Names (By_Eye : Boolean := True) return String;

   function Exists (Name : String) return Boolean;

   function Length (Name : String) return Microseconds
     with Pre => Exists (Name);

   --  True if the flight begins and ends on the runway: the pilot must see the
   --  aircraft.
   function Is_By_Eye (Name : String) return Boolean
     with Pre => Exists (Name);

   --  Starts a flight; the pilot keeps nothing from earlier ones.
   procedure Start (Name : String)
     with Pre => Exists (Name);

   --  Shows the aircraft to the pilot, several times a second.
   procedure See (Now : View);

   --  To be called once a major frame. Time is that since the beginning of the
   --  flight; after its end the last leg continues.
   procedure Move
     (Time     : Microseconds;
      Downlink : Downlink_Buffer;
      Console  : out Console_Words);

   --  To be called instead of Move while another source flies: the pilot
   --  watches the displays, to take the sticks without a jerk.
   procedure Watch (Downlink : Downlink_Buffer);

   --  The targets of the latest move.
   function Present_Targets return Targets;

end Host.Pilot;
