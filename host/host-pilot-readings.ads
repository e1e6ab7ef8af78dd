--  SPDX-License-Identifier: Apache-2.0

--  What the pilot reads off the displays, in engineering units.

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

   --  Before the first data the displays show an aircraft that stands
   --  still. No pilot believes that of an aircraft that was put into the
   --  air.
   function Is_Flying (Now : Reading) return Boolean is
     (Now.Airspeed > 20.0);

   --  How fast the heading changes to the right, in deg/s.
   function Turn_Rate (Now : Reading) return Long_Float;

   --  How fast the aircraft climbs in calm air, in ft/s: along the path,
   --  whose slope is pitch less alpha. The altitude's own changes are too
   --  coarse to steer by.
   function Climb_Rate (Now : Reading) return Long_Float;

   --  Good to five digits between -90 and 90 degrees, and taken as at the
   --  nearer end beyond. The library's functions may differ between
   --  machines.
   function Sine (Degrees : Long_Float) return Long_Float;
   function Cosine (Degrees : Long_Float) return Long_Float;

end Host.Pilot.Readings;
