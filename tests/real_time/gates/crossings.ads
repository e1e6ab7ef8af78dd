--  SPDX-License-Identifier: Apache-2.0

--  Two tasks that go through one gate again and again (D-30).

with Partitions.Gates; use Partitions.Gates;

package Crossings is

   Crossings_Of_Each : constant := 20_000;

   type Counts is array (Side) of Natural with Atomic_Components;

   --  How often each side has been inside.
   Crossed : Counts := (others => 0);

   --  The same of both, counted inside, where nobody else counts.
   Together : Natural := 0 with Volatile;

   task On_Left;
   task On_Right;

end Crossings;
