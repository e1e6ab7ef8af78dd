--  SPDX-License-Identifier: Apache-2.0

--  The pilot's estimate of the aircraft's position and motion (SIM-7), from
--  the displays and an occasional look at it. Between two looks it is dead
--  reckoning from speed, heading and wind.

with Host.Pilot.Readings; use Host.Pilot.Readings;

private package Host.Pilot.Pictures is

   type Picture is record
      --  The altimeter's reading at rest on the runway.
      Zero    : Long_Float := 0.0;         --  ft
      Zeroed  : Natural    := 0;           --  readings of it

      Height  : Long_Float := 0.0;         --  ft, of the wheels
      Climb   : Long_Float := 0.0;         --  ft/s
      Heading : Long_Float := 0.0;         --  deg, true; no bounds
      Turn    : Long_Float := 0.0;         --  deg/s
      North   : Long_Float := 0.0;         --  ft
      East    : Long_Float := 0.0;         --  ft

      --  Through the air and over the ground, and their difference.
      Speed       : Long_Float := 0.0;     --  ft/s
      North_Speed : Long_Float := 0.0;
      East_Speed  : Long_Float := 0.0;
      Wind_North  : Long_Float := 0.0;     --  towards the north
      Wind_East   : Long_Float := 0.0;
   end record;

   --  The aircraft is at rest on the runway.
   procedure Start (Made : out Picture);

   --  Advances the estimate by a fiftieth of a second. Wheels on the ground do
   --  not drift with the wind.
   procedure Dead_Reckon
     (Known     : in out Picture;
      Now       : Reading;
      On_Wheels : Boolean);

   --  At rest the altimeter's reading is taken as zero.
   procedure Set_Zero (Known : in out Picture; Now : Reading);

   procedure Correct
     (Known     : in out Picture;
      Seen      : View;
      On_Wheels : Boolean);

end Host.Pilot.Pictures;
