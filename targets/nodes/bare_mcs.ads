--  SPDX-License-Identifier: Apache-2.0

--  The main program of MCS on a bare machine.

package Bare_MCS is

   --  Starts the node at power up.
   procedure Start with No_Return;

end Bare_MCS;
