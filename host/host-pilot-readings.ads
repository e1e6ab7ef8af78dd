--  SPDX-License-Identifier: Apache-2.0

--  The pilot's readings of the displays, in engineering units.

private package Host.Pilot.Readings is

   type Reading is record
      Bank, Pitch, Alpha, Beta         : Long_Float := 0.0;   --  deg
      Roll_Rate, Pitch_Rate, Yaw_Rate  : Long_Float := 0.0;   --  deg/s
      Airspeed : Long_Float := 0.0;                           --  kt
      Altitude : Long_Float := 0.0;                           --  ft
      Flaps    : Long_Float := 0.0;                           --  deg
      Load     : Long_Float := 1.0;                           --  g, upward
   end record;

   function Read (Downlink : Downlink_Buffer) return Reading;

   --  Before the first data the displays show an aircraft at rest. The pilot
   --  ignores that for an aircraft that begins in the air.
   function Is_Flying (Now : Reading) return Boolean is
     (Now.Airspeed > 20.0);

   --  The rate of change of the heading to the right, in deg/s.
   function Turn_Rate (Now : Reading) return Long_Float;

   --  The climb rate in calm air, in ft/s: along the path, whose slope is
   --  pitch less alpha. The altitude's own changes are too coarse to steer by.
   function Climb_Rate (Now : Reading) return Long_Float;

   --  Accurate to five digits between -90 and 90 degrees; beyond that the
   --  nearer end is taken. The library's functions may differ between
   --  machines.
   function Sine (Degrees : Long_Float) return Long_Float;
   function Cosine (Degrees : Long_Float) return Long_Float;

end Host.Pilot.Readings;
