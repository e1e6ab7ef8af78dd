--  SPDX-License-Identifier: Apache-2.0

--  The pulse width modulation boards of this vehicle. From power up they hold
--  the safe words (SAF-1, D-13); without a controller they hold the unattended
--  words (SAF-11, D-34).

pragma SPARK_Mode;

with Devices.Shared_PWM_Board;
with URV.PWM_Layout;

package URV.PWM_Boards is new Devices.Shared_PWM_Board
  (Power_Up   => URV.PWM_Layout.Safe_Area,
   Unattended => URV.PWM_Layout.Unattended_Area);
