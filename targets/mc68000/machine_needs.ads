--  SPDX-License-Identifier: Apache-2.0

--  Makes the linker include the routines that the compiler calls here.

with Memory_Operations;
pragma Unreferenced (Memory_Operations);
with Wide_Arithmetic;
pragma Unreferenced (Wide_Arithmetic);

package Machine_Needs is
end Machine_Needs;
