--  SPDX-License-Identifier: Apache-2.0

--  Handles a failed run-time check: the processor restarts (KRN-6, BRD-2).

with System;

package Last_Chance is

   procedure Handle (File : System.Address; Line : Integer)
   with
     Export,
     Convention    => C,
     External_Name => "__gnat_last_chance_handler",
     No_Return;

end Last_Chance;
