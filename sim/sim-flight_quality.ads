--  SPDX-License-Identifier: Apache-2.0

--  How well the simulated pilot flew: what the aircraft really did against
--  what the pilot wanted.

with Host.Pilot;
with Host.Plant_Messages; use Host.Plant_Messages;
with Sim.Summary;

package Sim.Flight_Quality is

   --  How far something was from its target.
   type Deviation is record
      RMS     : Long_Float := 0.0;
      Largest : Long_Float := 0.0;
   end record;

   type Quality is record
      --  In holds. Bank is wanted to be zero there.
      Altitude : Deviation;     --  ft
      Airspeed : Deviation;     --  kt
      Bank     : Deviation;     --  deg

      --  In turns.
      Altitude_In_Turns : Deviation;   --  ft

      --  In the whole flight.
      Steepest_Left  : Long_Float := 0.0;   --  deg, not negative
      Steepest_Right : Long_Float := 0.0;   --  deg, not negative
      Highest_Gain   : Long_Float := 0.0;   --  ft above the first altitude

      --  At the end, real less wanted.
      Altitude_Error : Long_Float := 0.0;   --  ft
      Airspeed_Error : Long_Float := 0.0;   --  kt
      Bank_Error     : Long_Float := 0.0;   --  deg
      Heading_Error  : Long_Float := 0.0;   --  deg, -180 up to 180

      --  At the end: held, wings and path level, near the wanted altitude,
      --  and in one piece.
      Ended_Level : Boolean := False;
      Crashed     : Boolean := False;
      Crash_Time  : Microseconds := 0;   --  of meaning only after a crash
   end record;

   --  Forgets what was observed.
   procedure Start;

   --  To be called once a major frame. The first observation's altitude
   --  and heading are those that gain and turns count from.
   procedure Observe
     (Time   : Microseconds;
      Truth  : Flight_State;
      Wanted : Pilot.Targets);

   --  Of what was observed so far.
   function Result return Quality;

   --  The same as values of the summary, the crash's time only if there
   --  was one.
   procedure Report (To : in out Summary.Result);

end Sim.Flight_Quality;
