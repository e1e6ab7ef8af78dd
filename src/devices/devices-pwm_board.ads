--  SPDX-License-Identifier: Apache-2.0

--  The pulse width modulation board (report, 2.3.1, 4.8, INI-3).
--
--  The board reads its data area all the time, on its own: one word a servo
--  channel, then the discretes.

with URVOS; use URVOS;

package Devices.PWM_Board with Pure, SPARK_Mode is

   --  16 channels, of which the vehicle uses the first 14.
   type Channel_Number is range 1 .. 16;

   type Data_Area is array (Channel_Number) of Word;

   --  The middle of a channel's range: a surface at zero degrees.
   Neutral : constant Word := 16#800#;

end Devices.PWM_Board;
