--  SPDX-License-Identifier: Apache-2.0

--  The view of the aircraft from beside the runway (SIM-7): its place and
--  heading, both inexact.

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
      Seen  : out Pilot.View);

end Sim.Eyes;
