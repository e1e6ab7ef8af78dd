--  SPDX-License-Identifier: Apache-2.0

--  The proof's knowledge of a memory under the RAM test (TST-1).

with URVOS.Memories; use URVOS.Memories;

package URVOS.RAM_Models with Pure, SPARK_Mode is

   --  The proof knows nothing of a real memory.
   function Holds
     (Unused_Where : Word_Address; Unused_Data : Word) return Boolean
   is (False)
   with Global => null;

end URVOS.RAM_Models;
