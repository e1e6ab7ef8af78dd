--  SPDX-License-Identifier: Apache-2.0

--  What is so as a loop runs.

with URVOS; use URVOS;

package Canaries.Loops with Pure, SPARK_Mode is

   type Place is range 1 .. 8;
   type Row is array (Place) of Byte;

   --  Neither the first word nor any other has been seen before the loop.
   function Largest_Of (Source : Row) return Byte
   with Global => null;

   --  A sum that wraps round may fall.
   function Sum_Of (Source : Row) return Byte
   with Global => null;

   --  A loop that stands still on its last step.
   function Halvings (Value : Byte) return Word
   with Global => null;

   --  An invariant that holds, and says too little.
   function Index_Of (Source : Row; Wanted : Byte) return Place
   with
     Global => null,
     Post   =>
       (if (for some I in Place => Source (I) = Wanted)
        then Source (Index_Of'Result) = Wanted  --  VC_POSTCONDITION
       );

end Canaries.Loops;
