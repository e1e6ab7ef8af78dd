--  SPDX-License-Identifier: Apache-2.0

--  How well a circuit was flown: what the aircraft really did, against the
--  runway (SIM-7).

with Host.Plant_Messages; use Host.Plant_Messages;
with Sim.Summary;

package Sim.Circuit_Quality is

   --  Forgets what was observed.
   procedure Start;

   --  To be called once a major frame.
   procedure Observe (Time : Microseconds; Truth : Flight_State);

   --  What was observed, as values of the summary.
   procedure Report (To : in out Summary.Result);

end Sim.Circuit_Quality;
