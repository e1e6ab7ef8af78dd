--  SPDX-License-Identifier: Apache-2.0

--  The program of a telemetry board with an MC68000 of its own (report,
--  appendix A; BRD-8, BRD-10). Both nodes have the same: the station and the
--  lengths of the blocks are in the dual-ported memory.
--
--  The timer of the MC68681 gives the character times. Its receiver's
--  characters are taken at each character time: the receiver's interrupt would
--  cost as much again, and the receiver holds four characters.

with Interfaces; use Interfaces;

package Telemetry_Board_Program is

   --  Starts the board at power up.
   procedure Power_Up with No_Return;

   --  Starts the board with its memory kept. Condition is 1 for the reset
   --  switch, 2 for a restart of the processor.
   procedure Run (Condition : Integer_32)
   with Export, Convention => C, External_Name => "urv_run", No_Return;

private

   procedure On_Line
   with Export, Convention => C, External_Name => "urv_on_line";

   --  The interrupt's vector leads here: the compiler saves the registers.
   pragma Machine_Attribute (On_Line, "interrupt_handler");

end Telemetry_Board_Program;
