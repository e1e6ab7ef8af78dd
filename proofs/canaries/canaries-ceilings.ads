--  SPDX-License-Identifier: Apache-2.0

--  A task above the ceiling of what it calls, and one that ends.

with System;
with URVOS; use URVOS;

package Canaries.Ceilings with SPARK_Mode is

   protected Box
     with Priority => System.Default_Priority
   is
      procedure Put (Item : Word);
   private
      Contents : Word := 0;
   end Box;

   task Writer  --  VC_CEILING_PRIORITY_PROTOCOL
   with
     Priority => System.Default_Priority + 1,
     Global   => (In_Out => Box);

   task Once  --  VC_TASK_TERMINATION
   with Global => null;

end Canaries.Ceilings;
