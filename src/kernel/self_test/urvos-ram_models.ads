--  SPDX-License-Identifier: Apache-2.0

--  What the proof of the RAM test may know of a memory (TST-1).

with URVOS.Memories; use URVOS.Memories;

package URVOS.RAM_Models with Pure, SPARK_Mode is

   --  Of a real memory nothing is known.
   function Not_Known
     (Unused_Where : Word_Address;
      Unused_Data  : Word) return Boolean
   is (False)
   with Global => null;

end URVOS.RAM_Models;
