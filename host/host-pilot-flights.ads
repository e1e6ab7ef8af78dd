--  SPDX-License-Identifier: Apache-2.0

--  The predefined flights of the pilot.

private package Host.Pilot.Flights is

   --  A damped circuit is one with the rate damping law on (EXT-3).
   type Flight is
     (Standard_Flight, Level_Flight, Circuit_Flight, Damped_Circuit_Flight);

   --  The flights that need a view of the aircraft.
   subtype Flight_By_Eye is Flight
     range Circuit_Flight .. Damped_Circuit_Flight;

   function Name (Of_Flight : Flight) return String is
     (case Of_Flight is
         when Standard_Flight       => "standard",
         when Level_Flight          => "level",
         when Circuit_Flight        => "circuit",
         when Damped_Circuit_Flight => "damped-circuit");

   function Length (Of_Flight : Flight) return Microseconds;

   function Targets_At (Of_Flight : Flight; Time : Microseconds)
                        return Targets;

end Host.Pilot.Flights;
