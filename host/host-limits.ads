--  SPDX-License-Identifier: Apache-2.0

--  The limits of the aircraft's sensors (GND-11). The displays and the report
--  of the ground station take them from here, like the scales; docs/items.md
--  gives the reason for each.
--
--  Beyond a caution's limit the pilot should look, beyond a warning's act.

package Host.Limits is

   --  In the item's unit. An unreachable value means no limit.
   type Limit_Set is record
      Warning_Low  : Long_Float := Long_Float'First;
      Caution_Low  : Long_Float := Long_Float'First;
      Caution_High : Long_Float := Long_Float'Last;
      Warning_High : Long_Float := Long_Float'Last;
   end record;

   --  The same on both sides of zero.
   function Within (Caution, Warning : Long_Float) return Limit_Set is
     (-Warning, -Caution, Caution, Warning);

   function At_Least (Caution, Warning : Long_Float) return Limit_Set is
     (Warning_Low => Warning, Caution_Low => Caution, others => <>);

   --  Close to the linkage's stop: no travel is left to steer with.
   function Short_Of (Stop : Long_Float) return Limit_Set is
     (Caution_Low => 1.0 - Stop, Caution_High => Stop - 1.0, others => <>);

   type Sensor_Limits is array (Sensor_Item) of Limit_Set;

   Sensors : constant Sensor_Limits :=
     (Right_Aileron  | Left_Aileron  => Short_Of (Stop => 20.0),
      Right_Elevator | Left_Elevator => Short_Of (Stop => 25.0),
      Right_Rudder   | Left_Rudder   => Short_Of (Stop => 25.0),

      --  The wing stalls at 14 degrees, upside down at -12.5.
      Alpha => (-12.0, -8.0, 10.0, 13.0),
      Beta  => Within (Caution => 8.0, Warning => 15.0),

      Lateral_Acceleration  => Within (Caution => 0.3, Warning => 0.5),
      Vertical_Acceleration => (-1.0, 0.0, 2.5, 3.5),

      --  Full power at 7000. The alternator's voltage falls below 2500; an
      --  idling engine turns at 1800.
      RPM => (1_500.0, 2_500.0, 7_000.0, 7_300.0),

      --  The battery alone gives 24.6 V; charged by the alternator's 28 V it
      --  floats at 27.6 V.
      Battery_Volts    => (23.5, 25.0, 29.0, 31.0),
      Alternator_Volts => (24.5, 27.0, 29.0, 31.0),

      --  The simulated pilot banks 27 degrees.
      Roll_Attitude  => Within (Caution => 40.0, Warning => 60.0),
      Pitch_Attitude => Within (Caution => 20.0, Warning => 30.0),
      Roll_Rate      => Within (Caution => 40.0, Warning => 80.0),
      Pitch_Rate     => Within (Caution => 30.0, Warning => 45.0),
      Yaw_Rate       => Within (Caution => 20.0, Warning => 40.0),

      --  In level flight without flaps it stalls at 42 kt. The upper limits,
      --  and the lower ones of altitude, are near the end of the sensor's
      --  range.
      Airspeed => (48.0, 55.0, 110.0, 120.0),
      Altitude => (100.0, 200.0, 1_900.0, 2_000.0),

      --  The receiver is deaf at -120.
      Uplink_Signal_Strength =>
        At_Least (Caution => -100.0, Warning => -110.0),

      others => <>);

end Host.Limits;
