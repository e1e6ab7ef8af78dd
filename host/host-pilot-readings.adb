--  SPDX-License-Identifier: Apache-2.0

with Host.Scaling; use Host.Scaling;

package body Host.Pilot.Readings is

   Feet_Per_Second_Per_Knot : constant Long_Float := 1.687_81;
   Radians_Per_Degree       : constant Long_Float := 0.017_453_292_52;
   Right_Angle              : constant Long_Float := 90.0;

   function In_Radians (Degrees : Long_Float) return Long_Float is
     (Radians_Per_Degree
      * Long_Float'Max (-Right_Angle, Long_Float'Min (Right_Angle, Degrees)));

   function Read (Downlink : Downlink_Buffer) return Reading is

      function Value (Item : Sensor_Item) return Long_Float is
        (To_Unit (Downlink (Item), Sensors (Item)));

   begin
      return
        (Bank       => Value (Roll_Attitude),
         Pitch      => Value (Pitch_Attitude),
         Alpha      => Value (Alpha),
         Beta       => Value (Beta),
         Roll_Rate  => Value (Roll_Rate),
         Pitch_Rate => Value (Pitch_Rate),
         Yaw_Rate   => Value (Yaw_Rate),
         Airspeed   => Value (Airspeed),
         Altitude   => Value (Altitude),
         Load       => Value (Vertical_Acceleration),
         Flaps      =>
           (Value (Right_Flap_1) + Value (Left_Flap_1)
            + Value (Right_Flap_2) + Value (Left_Flap_2)) / 4.0);
   end Read;

   --  The heading has no meaning with the nose straight up.
   function Turn_Rate (Now : Reading) return Long_Float is
     ((Now.Pitch_Rate * Sine (Now.Bank) + Now.Yaw_Rate * Cosine (Now.Bank))
      / Long_Float'Max (0.1, Cosine (Now.Pitch)));

   function Climb_Rate (Now : Reading) return Long_Float is
     (Now.Airspeed * Feet_Per_Second_Per_Knot
      * Sine (Now.Pitch - Now.Alpha * Cosine (Now.Bank)));

   function Sine (Degrees : Long_Float) return Long_Float is
      X  : constant Long_Float := In_Radians (Degrees);
      X2 : constant Long_Float := X * X;
   begin
      return
        X * (1.0 - X2 / 6.0
             * (1.0 - X2 / 20.0 * (1.0 - X2 / 42.0 * (1.0 - X2 / 72.0))));
   end Sine;

   function Cosine (Degrees : Long_Float) return Long_Float is
      X  : constant Long_Float := In_Radians (Degrees);
      X2 : constant Long_Float := X * X;
   begin
      return
        1.0 - X2 / 2.0
        * (1.0 - X2 / 12.0
           * (1.0 - X2 / 30.0 * (1.0 - X2 / 56.0 * (1.0 - X2 / 90.0))));
   end Cosine;

end Host.Pilot.Readings;
