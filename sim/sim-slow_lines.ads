--  SPDX-License-Identifier: Apache-2.0

--  The characters that are on their way over a line slower than a wire
--  (LNK-11): each with the time when the other board hears it.

with Sim.Faulty_Line; use Sim.Faulty_Line;

package Sim.Slow_Lines is

   --  Nothing is on its way.
   procedure Clear;

   --  A character comes at that time, after all others of that time.
   procedure Put (Way : Direction; Time : Microseconds; Heard : Arrival);

   --  When the next one comes; Host.Never if there is none.
   function Next_Time (Way : Direction) return Microseconds;

   --  The next one has come. There must be one.
   procedure Take (Way : Direction; Heard : out Arrival);

end Sim.Slow_Lines;
