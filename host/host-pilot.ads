--  SPDX-License-Identifier: Apache-2.0

--  The simulated pilot at the console (SIM-3).
--
--  The pilot knows the flight by heart and sees what the ground's CORE
--  memory shows: words that are late, rounded, and sometimes not renewed.
--  There is no compass among them. The heading is reckoned from the rates.
--  In a circuit he stands beside the runway, and sees the aircraft too
--  (SIM-7).
--
--  Fifty times a second the sticks move: bank by ailerons, sideslip by
--  rudders, pitch by elevators, speed by throttle. The arithmetic is plain,
--  so that the same words always give the same sticks.

package Host.Pilot is

   --  What a part of a flight is for. Only a hold asks that everything
   --  stays at its target.
   type Leg_Kind is (Hold, Turn, Climb, Flap_Change);

   --  What the pilot wants at present.
   type Targets is record
      Kind       : Leg_Kind   := Hold;
      Altitude   : Long_Float := 0.0;     --  ft above the field
      Climb      : Long_Float := 0.0;     --  ft/s, of that altitude
      Airspeed   : Long_Float := 0.0;     --  kt
      Bank       : Long_Float := 0.0;     --  deg, that of a turn under way
      Heading    : Long_Float := 0.0;     --  deg right of the first heading
      Flaps_Down : Boolean    := False;   --  half flaps, by switch 8
   end record;

   --  What one beside the runway sees of the aircraft: from where it stands
   --  at the beginning, in ft, and where its nose points, in deg.
   type Sight is record
      North, East : Long_Float := 0.0;
      Heading     : Long_Float := 0.0;
   end record;

   --  Of the flights, in a list for people; or of those that the displays
   --  are enough for.
   function Names (By_Eye : Boolean := True) return String;

   function Exists (Name : String) return Boolean;

   function Length (Name : String) return Microseconds
     with Pre => Exists (Name);

   --  Whether the flight begins and ends on the runway, and the aircraft has
   --  to be seen.
   function Is_By_Eye (Name : String) return Boolean
     with Pre => Exists (Name);

   --  A rested pilot who knows nothing of earlier flights.
   procedure Start (Name : String)
     with Pre => Exists (Name);

   --  The aircraft is seen: some times a second.
   procedure See (Now : Sight);

   --  To be called once a major frame. Time is that since the beginning of
   --  the flight; after its end the last leg goes on.
   procedure Move
     (Time     : Microseconds;
      Downlink : Downlink_Buffer;
      Console  : out Console_Words);

   --  The same instead of Move while somebody else flies: the pilot keeps
   --  an eye on the displays, so as to take the sticks without a jerk.
   procedure Watch (Downlink : Downlink_Buffer);

   --  Of the latest move.
   function Present_Targets return Targets;

end Host.Pilot;
