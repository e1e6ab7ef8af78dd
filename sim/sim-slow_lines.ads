--  SPDX-License-Identifier: Apache-2.0

--  The characters in transit over a line slower than a wire (LNK-11), each
--  with the time of its arrival at the other board.

with Sim.Faulty_Line; use Sim.Faulty_Line;

package Sim.Slow_Lines is

   --  Removes all characters.
   procedure Clear;

   --  Adds a character that arrives at that time, after all others of that
   --  time.
   procedure Put (Path : Direction; Time : Microseconds; Heard : Arrival);

   --  The time of the next arrival; Host.Never if there is none.
   function Next_Time (Path : Direction) return Microseconds;

   --  Removes the next arrival. There must be one.
   procedure Take (Path : Direction; Heard : out Arrival);

end Sim.Slow_Lines;
