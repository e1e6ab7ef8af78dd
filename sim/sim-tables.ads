--  SPDX-License-Identifier: Apache-2.0

--  The lists that the ground shares with the flight software, as JSON:
--  `urv_sim tables` (GND-11). Each is declared elsewhere, once.

with Host.Text_Output;

package Sim.Tables is

   procedure Print (To : in out Text_Output.Writer)
     with Pre => Text_Output.Is_Open (To);

end Sim.Tables;
