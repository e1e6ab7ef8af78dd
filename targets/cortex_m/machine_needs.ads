--  SPDX-License-Identifier: Apache-2.0

--  What the compiler needs on this machine, for the linker.

with Memory_Operations;
pragma Unreferenced (Memory_Operations);
with Wide_Division;
pragma Unreferenced (Wide_Division);

package Machine_Needs is
end Machine_Needs;
