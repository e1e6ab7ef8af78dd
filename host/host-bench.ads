--  SPDX-License-Identifier: Apache-2.0

--  The bench: the surfaces follow the servos with a lag; every other sensor
--  keeps its last setting (SIM-1). Servos may fail (SIM-5). There is no wind,
--  so a floating surface hangs at zero.
--
--  The lag is computed in whole numbers, so that it is the same on every
--  machine. It is 64 ms without a rate limit. A flight's conditions may give
--  the servos another lag and a dead band (SIM-4).

with Host.Surface_Faults;

package Host.Bench is

   --  In thousandths of a per cent.
   type Share is range 0 .. 1_000_000;
   One_Per_Cent : constant Share := 1_000;

   --  The lag of all servos as a share of the bench's, and their dead band as
   --  a share of the surface's travel: within the dead band a servo rests.
   type Servo_Traits is record
      Lag       : Share range 1 .. Share'Last := 100 * One_Per_Cent;
      Dead_Band : Share                       := 0;
   end record;

   Usual_Servos : constant Servo_Traits := (others => <>);

   --  Puts the surfaces where neutral servos hold them, and measures them
   --  there.
   procedure Start
     (Faults   : Surface_Faults.List := Surface_Faults.None;
      Schedule : Schedule_Name := URVOS.Task_Trees.Report;
      Servos   : Servo_Traits  := Usual_Servos);

   --  Holds the servos' words for a major frame. Sensors receives the
   --  surfaces' positions Ticks_To_Scan after the frame's beginning, when the
   --  aircraft's next scan begins; its other words do not change.
   procedure Step (Servos : PWM_Buffer; Sensors : in out Sensor_Words);

end Host.Bench;
