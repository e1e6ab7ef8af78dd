--  SPDX-License-Identifier: Apache-2.0

--  The host simulation: the environment of the flight software, in virtual
--  time.

with Host; use Host;

package Sim is

   --  Ground to aircraft, aircraft to ground.
   type Direction is (Up, Down);

   --  The direction of a node's transmissions.
   function Path_From (Sender : Node) return Direction is
     (if Sender = Ground then Up else Down);

   function Other (Than : Node) return Node is
     (if Than = Ground then Aircraft else Ground);

end Sim;
