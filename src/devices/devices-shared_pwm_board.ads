--  SPDX-License-Identifier: Apache-2.0

--  A pulse width modulation board between the controller and the servos
--  (report, 4.8; PWM-1, D-13).

with Devices.PWM_Board; use Devices.PWM_Board;

generic
   --  What the board holds from power up until it is first written (SAF-1).
   Power_Up : Data_Area;
package Devices.Shared_PWM_Board with SPARK_Mode is

   protected type Board is

      --  The controller's side: the whole area at once.
      procedure Write (Area : Data_Area);

      --  The servos' side.
      function Contents return Data_Area;

   private
      Words : Data_Area := Power_Up;
   end Board;

end Devices.Shared_PWM_Board;
