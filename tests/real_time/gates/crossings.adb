--  SPDX-License-Identifier: Apache-2.0

with Ada.Real_Time; use Ada.Real_Time;

package body Crossings is

   Between : Gate;

   procedure Cross (From : Side);

   procedure Cross (From : Side) is
      Inside : Natural;
   begin
      for Number in 1 .. Crossings_Of_Each loop
         Enter (Between, From);
         Inside := Together;
         Together := Inside + 1;
         Leave (Between, From);
         Crossed (From) := Number;
      end loop;

      --  A task of the profile does not end.
      loop
         delay until Time_Last;
      end loop;
   end Cross;

   task body On_Left is
   begin
      Cross (Left);
   end On_Left;

   task body On_Right is
   begin
      Cross (Right);
   end On_Right;

end Crossings;
