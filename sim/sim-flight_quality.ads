--  SPDX-License-Identifier: Apache-2.0

--  The quality of the simulated pilot's flight: the aircraft's true state
--  compared with the pilot's targets.

with Host.Pilot;
with Host.Plant_Messages; use Host.Plant_Messages;
with Sim.Summary;

package Sim.Flight_Quality is

   --  The deviation of a value from its target; unknown when there was none.
   type Deviation is record
      Is_Known : Boolean    := False;
      RMS      : Long_Float := 0.0;
      Largest  : Long_Float := 0.0;
   end record;

   type Quality is record
      --  In holds. The target bank is zero there.
      Altitude : Deviation;     --  ft
      Airspeed : Deviation;     --  kt
      Bank     : Deviation;     --  deg

      --  In turns.
      Altitude_In_Turns : Deviation;   --  ft

      --  In the whole flight.
      Steepest_Left  : Long_Float := 0.0;   --  deg, not negative
      Steepest_Right : Long_Float := 0.0;   --  deg, not negative
      Highest_Gain   : Long_Float := 0.0;   --  ft above the first altitude

      --  At the end, true less wanted.
      Altitude_Error : Long_Float := 0.0;   --  ft
      Airspeed_Error : Long_Float := 0.0;   --  kt
      Bank_Error     : Long_Float := 0.0;   --  deg
      Heading_Error  : Long_Float := 0.0;   --  deg, -180 up to 180

      --  At the end: in a hold, wings and path level, near the wanted
      --  altitude, not crashed.
      Ended_Level : Boolean := False;
      Crashed     : Boolean := False;
      Crash_Time  : Microseconds := 0;   --  has a meaning only after a crash
   end record;

   --  Forgets all observations.
   procedure Start;

   --  To be called once a major frame. Gain and turns are relative to the
   --  first observation's altitude and heading.
   procedure Observe
     (Time   : Microseconds;
      Truth  : Flight_State;
      Wanted : Pilot.Targets);

   --  The quality so far.
   function Result return Quality;

   --  The same as values of the summary; the crash's time only after a crash.
   procedure Report (To : in out Summary.Result);

end Sim.Flight_Quality;
