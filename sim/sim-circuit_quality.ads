--  SPDX-License-Identifier: Apache-2.0

--  The quality of a circuit: the true flight compared with the runway (SIM-7).

with Host.Plant_Messages; use Host.Plant_Messages;
with Sim.Summary;

package Sim.Circuit_Quality is

   --  Forgets all observations.
   procedure Start;

   --  To be called once a major frame.
   procedure Observe (Time : Microseconds; Truth : Flight_State);

   --  Reports the observations as values of the summary.
   procedure Report (To : in out Summary.Result);

end Sim.Circuit_Quality;
