--  SPDX-License-Identifier: Apache-2.0

--  Where the pilot believes that the aircraft is, and how it moves (SIM-7):
--  from the displays and, now and then, a look at it. Between two looks the
--  place is reckoned from speed, heading and wind.

with Host.Pilot.Readings; use Host.Pilot.Readings;

private package Host.Pilot.Pictures is

   type Picture is record
      --  What the altimeter shows while the aircraft stands.
      Zero    : Long_Float := 0.0;         --  ft
      Zeroed  : Natural    := 0;           --  readings of it

      Height  : Long_Float := 0.0;         --  ft, of the wheels
      Climb   : Long_Float := 0.0;         --  ft/s
      Heading : Long_Float := 0.0;         --  deg, true; no bounds
      Turn    : Long_Float := 0.0;         --  deg/s
      North   : Long_Float := 0.0;         --  ft
      East    : Long_Float := 0.0;         --  ft

      --  Through the air and over the ground, and what is between.
      Speed       : Long_Float := 0.0;     --  ft/s
      North_Speed : Long_Float := 0.0;
      East_Speed  : Long_Float := 0.0;
      Wind_North  : Long_Float := 0.0;     --  towards the north
      Wind_East   : Long_Float := 0.0;
   end record;

   --  The aircraft stands on the runway.
   procedure Start (Made : out Picture);

   --  Another fiftieth of a second has gone by. Wheels on the ground do not
   --  drift with the wind.
   procedure Reckon
     (Known     : in out Picture;
      Now       : Reading;
      On_Wheels : Boolean);

   --  It stands: what the altimeter shows is zero.
   procedure Set_Zero (Known : in out Picture; Now : Reading);

   procedure Correct
     (Known     : in out Picture;
      Seen      : Sight;
      On_Wheels : Boolean);

end Host.Pilot.Pictures;
