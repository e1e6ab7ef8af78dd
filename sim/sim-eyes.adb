--  SPDX-License-Identifier: Apache-2.0

with Host.Runway;

package body Sim.Eyes is

   --  Standard deviations: of each axis of the place, one foot and one
   --  hundredth of the distance; and of the heading.
   Nearby      : constant Long_Float := 1.0;     --  ft
   By_Distance : constant Long_Float := 0.01;
   Of_Heading  : constant Long_Float := 3.0;     --  deg

   procedure Look
     (Shown : Shown_State;
      From  : in out Noise.Source;
      Seen  : out Pilot.View)
   is
      North  : constant Long_Float :=
        abs (Shown (North_Ft) - Runway.Observer_North);
      East   : constant Long_Float :=
        abs (Shown (East_Ft) - Runway.Observer_East);

      --  Without a square root: at most a tenth too much.
      Spread : constant Long_Float :=
        Nearby
        + By_Distance
          * (Long_Float'Max (North, East)
             + 0.4 * Long_Float'Min (North, East));
      Drawn  : array (1 .. 3) of Long_Float;
   begin
      for Number of Drawn loop
         Noise.Draw (From, Number);
      end loop;
      Seen :=
        (North   => Shown (North_Ft) + Spread * Drawn (1),
         East    => Shown (East_Ft) + Spread * Drawn (2),
         Heading => Shown (Heading_Deg) + Of_Heading * Drawn (3));
   end Look;

end Sim.Eyes;
