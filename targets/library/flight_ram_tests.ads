--  SPDX-License-Identifier: Apache-2.0

--  The march through the RAM in flight (report, 2.4; TST-5), for scratchpad,
--  variables and stack. Each cell, a long word, is tested while interrupts are
--  masked, and keeps its contents: also over a reset or a restart of the
--  processor within its test (start.s). The other processor of a telemetry
--  board reaches none of these cells.

with URVOS.Memories; use URVOS.Memories;

package Flight_RAM_Tests is

   --  A minor frame has begun: some more cells may be tested.
   procedure Begin_Tick
   with Inline;

   --  A cell may be tested now.
   function Has_Cell return Boolean
   with Inline;

   --  Tests the next cell. If it is not sound, Where is its word's address:
   --  first the scratchpad, as in the self-test before a start, then the RAM
   --  of variables and stack.
   procedure Test_Cell (Is_Sound : out Boolean; Where : out Word_Address);

end Flight_RAM_Tests;
