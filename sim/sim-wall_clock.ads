--  SPDX-License-Identifier: Apache-2.0

--  Real time, for the pace and the speed of a flight. It is monotonic: setting
--  the machine's date does not change it.

package Sim.Wall_Clock is

   --  The time since a fixed instant, which is not specified.
   function Now return Duration;

   --  Returns at that time, or earlier when a signal has arrived.
   procedure Wait (Until_Time : Duration);

end Sim.Wall_Clock;
