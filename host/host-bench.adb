--  SPDX-License-Identifier: Apache-2.0

package body Host.Bench is

   subtype Surface is Sensor_Item range Right_Flap_1 .. Left_Rudder;

   --  The servo that moves a surface.
   Servo_Of : constant array (Surface) of Servo_Item :=
     (Right_Flap_1   => Right_Flap_1,
      Left_Flap_1    => Left_Flap_1,
      Right_Flap_2   => Right_Flap_2,
      Left_Flap_2    => Left_Flap_2,
      Right_Aileron  => Right_Aileron,
      Left_Aileron   => Left_Aileron,
      Right_Elevator => Right_Elevator,
      Left_Elevator  => Left_Elevator,
      Right_Rudder   => Right_Rudder,
      Left_Rudder    => Left_Rudder);

   --  Positions are counted in parts of a converter word. In each tick a
   --  surface makes such a part of the way to go that it lags by 64 ms.
   type Position is range 0 .. 4_095 * 2 ** 10;
   Parts : constant := 2 ** 10;
   Lag   : constant := 64_000 / Microseconds_Per_Tick;

   type Place_Table is array (Surface) of Position;

   Rest   : constant Position := Position (Neutral_Value) * Parts;
   Places : Place_Table       := (others => Rest);

   --  Moves by at least one part, so that it arrives.
   function Moved (From, To : Position) return Position is
     (if From < To then From + Position'Max (1, (To - From) / Lag)
      elsif From > To then From - Position'Max (1, (From - To) / Lag)
      else From);

   procedure Start is
   begin
      Places := (others => Rest);
   end Start;

   procedure Step (Servos : PWM_Buffer; Sensors : in out Sensor_Words) is
      Goal : Position;
   begin
      for Item in Surface loop
         Goal := Position (Servos (Servo_Of (Item))) * Parts;
         if Places (Item) /= Goal then
            for I in 1 .. Ticks_To_Scan loop
               Places (Item) := Moved (Places (Item), Goal);
            end loop;
         end if;
         Sensors (Item) := Word (Places (Item) / Parts);
         if Places (Item) /= Goal then
            for I in 1 .. Servo_Tick loop
               Places (Item) := Moved (Places (Item), Goal);
            end loop;
         end if;
      end loop;
   end Step;

end Host.Bench;
