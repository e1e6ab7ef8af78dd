--  SPDX-License-Identifier: Apache-2.0

--  What one beside the runway sees of the aircraft (SIM-7): where it is, and
--  where its nose points, neither of them well.

with Host.Pilot;
with Host.Plant_Messages; use Host.Plant_Messages;
with Sim.Noise;

package Sim.Eyes is

   --  Five times a second.
   Frames_Between : constant := 10;

   --  The state with the errors of a look.
   procedure Look
     (Shown : Shown_State;
      From  : in out Noise.Source;
      Seen  : out Pilot.Sight);

end Sim.Eyes;
