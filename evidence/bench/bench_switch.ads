--  SPDX-License-Identifier: Apache-2.0

--  Two tasks of the Ravenscar profile that hand over to each other.

package Bench_Switch is

   --  The other task runs, and hands back: two switches.
   procedure There_And_Back (Turn : Positive);

end Bench_Switch;
