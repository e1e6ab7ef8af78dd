--  SPDX-License-Identifier: Apache-2.0

--  The constants that scripts about a flight need, as JSON: `urv_sim numbers`.
--  Each is declared elsewhere, once.

with Host.Text_Output;

package Sim.Numbers is

   procedure Print (To : in out Text_Output.Writer)
     with Pre => Text_Output.Is_Open (To);

end Sim.Numbers;
