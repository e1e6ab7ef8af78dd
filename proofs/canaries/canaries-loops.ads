--  SPDX-License-Identifier: Apache-2.0

--  False claims about running loops.

with URVOS; use URVOS;

package Canaries.Loops with Pure, SPARK_Mode is

   type Place is range 1 .. 8;
   type Row is array (Place) of Byte;

   --  False before the loop: it has seen no word.
   function Largest_Of (Source : Row) return Byte
   with Global => null;

   --  False: a sum that wraps round may fall.
   function Sum_Of (Source : Row) return Byte
   with Global => null;

   --  False: the last step of the loop does not decrease its variant.
   function Halvings (Value : Byte) return Word
   with Global => null;

   --  A true invariant that is too weak for the postcondition.
   function Index_Of (Source : Row; Wanted : Byte) return Place
   with
     Global => null,
     Post   =>
       (if (for some I in Place => Source (I) = Wanted)
        then Source (Index_Of'Result) = Wanted  --  VC_POSTCONDITION
       );

end Canaries.Loops;
