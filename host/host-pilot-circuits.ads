--  SPDX-License-Identifier: Apache-2.0

--  How the pilot flies a circuit (SIM-7): off the runway, round by the left,
--  and back onto it.

with Host.Pilot.Readings; use Host.Pilot.Readings;

private package Host.Pilot.Circuits is

   --  Long enough against any wind that he would fly in.
   Length : constant Microseconds := 300 * Microseconds_Per_Second;

   --  A rested pilot, before an aircraft that stands on the runway.
   procedure Start;

   --  To be called once a major frame. What is old teaches nothing, and
   --  moves nothing.
   procedure Move
     (Now     : Reading;
      Is_Old  : Boolean;
      Seen    : Sight;
      Is_New  : Boolean;
      Console : out Console_Words);

end Host.Pilot.Circuits;
