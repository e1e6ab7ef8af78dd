--  SPDX-License-Identifier: Apache-2.0

--  The main program of GSC on a bare machine, with the handlers that
--  targets.ads lists.

with Interfaces; use Interfaces;

package Bare_GSC is

   --  Condition is 1 for the reset switch, 2 for a restart of the processor.
   procedure Run (Condition : Integer_32)
   with Export, Convention => C, External_Name => "urv_run", No_Return;

   --  Starts the node at power up.
   procedure Start with No_Return;

private

   procedure On_Tick
   with Export, Convention => C, External_Name => "urv_tick";

   procedure On_Character_Time
   with Export, Convention => C, External_Name => "urv_character_time";

   procedure On_Character (Data : Unsigned_32; Damaged : Unsigned_32)
   with Export, Convention => C, External_Name => "urv_character";

   procedure On_Free_Sender
   with Export, Convention => C, External_Name => "urv_free_sender";

   procedure On_Converted (Value : Unsigned_32)
   with Export, Convention => C, External_Name => "urv_converted";

   --  For the emulator: settings before the start, a row of words at the end
   --  of a major frame, and the counts

   procedure Configure (Flags : Unsigned_32; Line_Delay : Unsigned_32)
   with Export, Convention => C, External_Name => "urv_configure";

   procedure Put_Row
   with Export, Convention => C, External_Name => "urv_put_row";

   procedure Put_Counts
   with Export, Convention => C, External_Name => "urv_put_counts";

end Bare_GSC;
