--  SPDX-License-Identifier: Apache-2.0

--  The test of the RAM that has the variables and the stack (report, 2.4;
--  TST-1, BRD-3, BRD-10). Start-up code calls it at power up, before variables
--  have their first values. It uses no variables, and a stack in the
--  scratchpad, which the node's own self-test marches through later.

with System;

package Power_Up_Tests is

   --  Tests all words from First to the one before After, and leaves zeros.
   --  If one is faulty, it says so on the console, and the processor stops.
   procedure Run (First, After : System.Address)
   with Export, Convention => C, External_Name => "urv_test_ram";

end Power_Up_Tests;
