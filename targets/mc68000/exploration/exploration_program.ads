--  SPDX-License-Identifier: Apache-2.0

--  Does the operations on the dual-ported memory that explore.c orders, and
--  reports their results (BRD-8). Both processors of an exploration run it,
--  each with orders of its own.

with Interfaces; use Interfaces;

package Exploration_Program is

   procedure Run with No_Return;

private

   procedure Restart (Condition : Integer_32)
   with Export, Convention => C, External_Name => "urv_run";

   procedure On_Line is null
   with Export, Convention => C, External_Name => "urv_on_line";

end Exploration_Program;
