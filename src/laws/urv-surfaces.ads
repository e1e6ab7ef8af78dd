--  SPDX-License-Identifier: Apache-2.0

--  The ten aerodynamic surfaces. Their positions are measured, and the other
--  surfaces make up for one that fails (EXT-6).
--
--  Demands and positions are words minus the neutral word, in the same scale.

with URV.Buffers;   use URV.Buffers;
with URV.Law_Units; use URV.Law_Units;

package URV.Surfaces with Pure, SPARK_Mode is

   type Surface is
     (Left_Aileron, Right_Aileron, Left_Elevator, Right_Elevator,
      Left_Rudder, Right_Rudder,
      Left_Flap_1, Right_Flap_1, Left_Flap_2, Right_Flap_2);

   subtype Flap is Surface range Left_Flap_1 .. Right_Flap_2;

   type Surface_Flags is array (Surface) of Boolean
   with Alignment => 2;
   type Surface_Demands is array (Surface) of Demand
   with Component_Size => 16;

   None : constant Surface_Flags := (others => False);

   function Servo_Of (Item : Surface) return Servo_Item is
     (case Item is
         when Left_Aileron   => Left_Aileron,
         when Right_Aileron  => Right_Aileron,
         when Left_Elevator  => Left_Elevator,
         when Right_Elevator => Right_Elevator,
         when Left_Rudder    => Left_Rudder,
         when Right_Rudder   => Right_Rudder,
         when Left_Flap_1    => Left_Flap_1,
         when Right_Flap_1   => Right_Flap_1,
         when Left_Flap_2    => Left_Flap_2,
         when Right_Flap_2   => Right_Flap_2)
   with Global => null;

   function Sensor_Of (Item : Surface) return Sensor_Item is
     (case Item is
         when Left_Aileron   => Left_Aileron,
         when Right_Aileron  => Right_Aileron,
         when Left_Elevator  => Left_Elevator,
         when Right_Elevator => Right_Elevator,
         when Left_Rudder    => Left_Rudder,
         when Right_Rudder   => Right_Rudder,
         when Left_Flap_1    => Left_Flap_1,
         when Right_Flap_1   => Right_Flap_1,
         when Left_Flap_2    => Left_Flap_2,
         when Right_Flap_2   => Right_Flap_2)
   with Global => null;

   --  The linkages' stops. A flap does not move up beyond its rest position.

   function Lowest (Item : Surface) return Demand is
     (if Item in Flap then 0 else -2_000)
   with Global => null;

   function Highest (Item : Surface) return Demand is
     (if Item in Flap then Demand'Last else 2_000)
   with Global => null;

   --  The demand that a surface can follow.
   function Reachable (Item : Surface; Wanted : Number) return Demand is
     (Within (Wanted, Lowest (Item), Highest (Item)))
   with
     Global => null,
     Post   => Reachable'Result in Lowest (Item) .. Highest (Item);

   --  From servo words and from sensor words

   function Demands_Of (Servos : PWM_Buffer) return Surface_Demands is
     (for Item in Surface => Demand_Of (Servos (Servo_Of (Item))))
   with Global => null;

   function Places_Of (Sensors : Downlink_Buffer) return Surface_Demands is
     (for Item in Surface => Demand_Of (Sensors (Sensor_Of (Item))))
   with Global => null;

end URV.Surfaces;
