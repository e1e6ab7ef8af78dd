--  SPDX-License-Identifier: Apache-2.0

--  The servos' pulses at the outputs of the timers 2 to 5 (BRD-9): channel 1
--  at output 1 of timer 2, and so on, up to channel 13 at output 1 of timer 5.

with Devices.PWM_Board; use Devices.PWM_Board;

package Servo_Outputs is

   Last_Channel : constant Channel_Number := 13;

   --  The chip was reset, and its timers stand still: the next Write starts
   --  them. Until then the servos get no pulses, and stay where they are.
   procedure Open;

   --  The pulses of these words, each from the end of the present one on.
   procedure Write (Area : Data_Area);

end Servo_Outputs;
