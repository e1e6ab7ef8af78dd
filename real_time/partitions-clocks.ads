--  The partition's time: since the machine was started, and since the node
--  was switched on.

with Ada.Real_Time; use Ada.Real_Time;

with Sim;

package Partitions.Clocks is

   --  The node is switched on now.
   procedure Switch_On;

   function Switched_On_At return Time;

   --  Since the node was switched on.
   function Elapsed return Sim.Microseconds;

   --  Since the machine was: what two partitions of one machine share.
   function Machine_Time (At_Time : Time) return Sim.Microseconds;

end Partitions.Clocks;
