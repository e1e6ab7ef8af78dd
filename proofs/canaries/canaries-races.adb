--  SPDX-License-Identifier: Apache-2.0

package body Canaries.Races with SPARK_Mode is

   task body Up is
   begin
      loop
         Frames := Incremented (Frames);
      end loop;
   end Up;

   task body Down is
   begin
      loop
         Frames := 0;
      end loop;
   end Down;

end Canaries.Races;
