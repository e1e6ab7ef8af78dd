--  SPDX-License-Identifier: Apache-2.0

--  Ends when both sides have crossed: says how often they were inside.

with Ada.Real_Time; use Ada.Real_Time;
with GNAT.IO;       use GNAT.IO;
with GNAT.OS_Lib;

with Crossings;      use Crossings;

procedure Cross_Gate is
   Look_Again : constant Time_Span := Milliseconds (10);
begin
   while (for some Number of Crossed => Number < Crossings_Of_Each) loop
      delay until Clock + Look_Again;
   end loop;
   Put_Line (Together'Image);
   GNAT.OS_Lib.OS_Exit (0);
end Cross_Gate;
