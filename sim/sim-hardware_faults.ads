--  SPDX-License-Identifier: Apache-2.0

--  The faults of a script that hit a node's hardware at an instant, one after
--  the other: resets, and damage to a processor's memory.

with Sim.Faults; use Sim.Faults;

package Sim.Hardware_Faults is

   --  Begins with the first of the script.
   procedure Prepare (From : Script);

   --  The time of the next one; Never when there is none.
   function Next_Time return Microseconds;

   --  Faults of the same instant come in the order of their lines.
   procedure Take_Next (Item : out Fault)
   with Pre => Next_Time < Never;

end Sim.Hardware_Faults;
