--  SPDX-License-Identifier: Apache-2.0

--  The runway of a circuit (SIM-7). The origin is the aircraft's place at the
--  beginning, on the centre line: East is along it, North is to its left.

package Host.Runway is

   Heading : constant Long_Float := 90.0;    --  deg, true

   --  Both ends, and the distance of its edges from the middle.
   West_End   : constant Long_Float := -100.0;    --  ft
   East_End   : constant Long_Float := 2_900.0;   --  ft
   Half_Width : constant Long_Float := 40.0;      --  ft

   --  The observer's place: beside the touchdown point.
   Observer_East  : constant Long_Float := 700.0;   --  ft
   Observer_North : constant Long_Float := -80.0;   --  ft

   function Is_On (North, East : Long_Float) return Boolean is
     (East in West_End .. East_End
      and then North in -Half_Width .. Half_Width);

end Host.Runway;
