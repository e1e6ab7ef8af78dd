--  SPDX-License-Identifier: Apache-2.0

--  Two tasks write one unprotected variable.

with URVOS; use URVOS;

package Canaries.Races with SPARK_Mode is

   Frames : Count := 0;

   task Up  --  CONCURRENT_ACCESS
   with Global => (In_Out => Frames);

   task Down
   with Global => (In_Out => Frames);

end Canaries.Races;
