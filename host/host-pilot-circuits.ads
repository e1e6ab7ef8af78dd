--  SPDX-License-Identifier: Apache-2.0

--  The simulated pilot's circuit (SIM-7): off the runway, round by the left,
--  and back onto it.

with Host.Pilot.Readings; use Host.Pilot.Readings;

private package Host.Pilot.Circuits is

   --  Long enough against any wind in which the pilot would fly.
   Length : constant Microseconds := 300 * Microseconds_Per_Second;

   --  Resets the pilot, for an aircraft parked on the runway.
   procedure Start;

   --  To be called once a major frame. With old data the pilot neither moves
   --  the sticks nor adjusts the trims.
   procedure Move
     (Now     : Reading;
      Is_Old  : Boolean;
      Seen    : View;
      Is_New  : Boolean;
      Console : out Console_Words);

end Host.Pilot.Circuits;
