--  SPDX-License-Identifier: Apache-2.0

--  TIN-1, TOU-1: the tasks between a node and its telemetry board.

with AUnit.Test_Suites;

package Telemetry_Task_Tests is

   procedure Add_To (Suite : AUnit.Test_Suites.Access_Test_Suite);

end Telemetry_Task_Tests;
