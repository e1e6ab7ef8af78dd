--  SPDX-License-Identifier: Apache-2.0

--  The clock on the wall, for the pace and the speed of a flight. A change of
--  the machine's date does not move it.

package Sim.Wall_Clock is

   --  The time since an unknown instant before the program's start.
   function Now return Duration;

   --  Returns at that time, or earlier when a signal has arrived.
   procedure Wait (Until_Time : Duration);

end Sim.Wall_Clock;
