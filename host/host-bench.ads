--  SPDX-License-Identifier: Apache-2.0

--  The bench: the surfaces follow the servos with a lag, every other sensor
--  is held at what it was last set to (SIM-1). Their servos may fail (SIM-5):
--  there is no wind, so that a floating surface hangs at zero.
--
--  The lag is computed in whole numbers, so that it is the same everywhere.

with Host.Surface_Faults;

package Host.Bench is

   --  The surfaces are where neutral servos hold them, and come to be
   --  measured there.
   procedure Start
     (Faults   : Surface_Faults.List := Surface_Faults.None;
      Schedule : Schedule_Name := URVOS.Task_Trees.Report);

   --  The servos' words are held for a major frame. Sensors receives the
   --  surfaces' positions Ticks_To_Scan after its beginning, when the
   --  aircraft's next scan begins; its other words are left alone.
   procedure Step (Servos : PWM_Buffer; Sensors : in out Sensor_Words);

end Host.Bench;
