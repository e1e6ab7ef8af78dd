--  SPDX-License-Identifier: Apache-2.0

package body URV.Sensor_Checks with SPARK_Mode is

   --  Not in the specification: a prover that sees a table of so many rules
   --  takes seconds for each goal.
   type Rule_Table is array (Law_Item) of Rule;

   --  Surfaces move 100 deg/s at most, flaps 5; engine and electrics change
   --  slowly, but their ends are the converter's own. The ends of the
   --  attitude and the rates are not believed: 4095 and 0 are a broken wire.
   Rules : constant Rule_Table :=
     (Right_Flap_1  => (1, Any, 200, Right_Flap_1, Any),
      Left_Flap_1   => (1, Any, 200, Left_Flap_1, Any),
      Right_Flap_2  => (1, Any, 200, Right_Flap_2, Any),
      Left_Flap_2   => (1, Any, 200, Left_Flap_2, Any),
      Right_Aileron => (1, 4_094, 600, Right_Aileron, Any),
      Left_Aileron  => (1, 4_094, 600, Left_Aileron, Any),
      Right_Elevator => (1, 4_094, 600, Right_Elevator, Any),
      Left_Elevator => (1, 4_094, 600, Left_Elevator, Any),
      Right_Rudder  => (1, 4_094, 600, Right_Rudder, Any),
      Left_Rudder   => (1, 4_094, 600, Left_Rudder, Any),
      Alpha         => (1, 4_094, 600, Alpha, Any),
      Beta          => (1, 4_094, 600, Beta, Any),
      Altitude_Offset => (0, 4_000, 5, Altitude_Offset, Any),
      Lateral_Acceleration      => (1, 4_094, Any, Lateral_Acceleration, Any),
      Longitudinal_Acceleration =>
        (1, 4_094, Any, Longitudinal_Acceleration, Any),
      Vertical_Acceleration     => (1, 4_094, Any, Vertical_Acceleration, Any),
      RPM              => (0, 4_000, 500, RPM, Any),
      Battery_Volts    => (500, 4_000, 500, Battery_Volts, Any),
      Alternator_Volts => (0, 4_000, 1_000, Alternator_Volts, Any),
      Roll_Attitude    => (1, 4_094, 60, Roll_Rate, 100),
      Pitch_Attitude   => (1, 4_094, 60, Pitch_Rate, 200),
      Roll_Rate        => (1, 4_094, 400, Roll_Attitude, 340),
      Pitch_Rate       => (1, 4_094, 800, Pitch_Attitude, 340),
      Yaw_Rate         => (1, 4_094, 800, Roll_Attitude, 340),
      Airspeed         => (0, 4_000, 320, Altitude, 400),
      Altitude         => (0, 4_094, 60, Pitch_Attitude, 340));

   function Rule_Of (Item : Sensor_Item) return Rule is
     (if Item in Law_Item then Rules (Item) else (0, Any, Any, Item, Any));

   function Invalid_Bits (Items : Check_Table; Which : Half) return Word is
      Result : Word := 0;
   begin
      for Item in Sensor_Item loop
         if Sensor_Item'Pos (Item) / 16 = Integer (Which)
           and then not Items (Item).Is_Valid
         then
            Result := Result or 2 ** (Sensor_Item'Pos (Item) mod 16);
         end if;
      end loop;
      return Result;
   end Invalid_Bits;

end URV.Sensor_Checks;
