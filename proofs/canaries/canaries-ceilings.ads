--  SPDX-License-Identifier: Apache-2.0

--  A task whose priority is above the ceiling of the object that it calls, and
--  a task that ends.

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
