--  SPDX-License-Identifier: Apache-2.0

--  A progress bar on standard error. It appears only on a terminal, and only
--  when the flight takes long.

package Sim.Progress is

   --  Starts before a flight of that length. Without Wanted all later calls do
   --  nothing. Beside: standard output is in use, and there is no bar where
   --  both are a terminal.
   procedure Start
     (Length : Microseconds;
      Wanted : Boolean;
      Beside : Boolean := False);

   --  Shows the progress of the flight. It costs almost nothing, so that it
   --  can be called each frame.
   procedure Show (Time : Microseconds) with Inline;

   --  Removes the bar, before anything else is printed.
   procedure Stop;

end Sim.Progress;
