--  SPDX-License-Identifier: Apache-2.0

--  A pulse width modulation board, shared by the controller and the servos
--  (report, 4.8; PWM-1, D-13), with its hold timer (SAF-11, D-34).

with Devices.PWM_Board; use Devices.PWM_Board;

generic
   --  The words from power up to the first write (SAF-1).
   Power_Up : Data_Area;

   --  The words without a controller, if the last ones were Words (SAF-11).
   with function Unattended (Words : Data_Area) return Data_Area;
package Devices.Shared_PWM_Board with SPARK_Mode is

   protected type Board is

      --  The controller's side: writes the whole area at once, or only shows
      --  that a controller is present.
      procedure Write (Area : Data_Area);
      procedure Touch;

      --  The board's clock ticks.
      procedure Tick;

      --  The servos' side
      function Contents return Data_Area;

      --  The words may have changed since the last call, at first since power
      --  up.
      procedure Look_For_Change (Changed : out Boolean);

      --  The timer has replaced the words, and the controller has not written
      --  or touched the board since.
      function Is_Unattended return Boolean;

   private
      State : Board_State := (Words => Power_Up, others => <>);
   end Board;

end Devices.Shared_PWM_Board;
