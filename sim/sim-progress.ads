--  SPDX-License-Identifier: Apache-2.0

--  A progress bar on standard error, for a person who waits. It appears
--  only on a terminal, and only when the flight takes long.

package Sim.Progress is

   --  Before a flight of that length. Without Wanted all calls that follow
   --  do nothing. Beside: standard output has other things to show, and
   --  there is no bar where both are a terminal.
   procedure Start
     (Length : Microseconds;
      Wanted : Boolean;
      Beside : Boolean := False);

   --  The flight has come so far. Costs next to nothing, so that it can be
   --  called each frame.
   procedure Show (Time : Microseconds) with Inline;

   --  Takes the bar away, before anything else is printed.
   procedure Stop;

end Sim.Progress;
