--  SPDX-License-Identifier: Apache-2.0

--  A node's program on a bare machine (BRD-1), in place of a host's
--  partitions, with the handlers that targets.ads lists. An image has one
--  instance.

with Interfaces;   use Interfaces;
with Telemetry.Shared_Boards;
with URV.AD_Boards;
with URV.AD_Scans; use URV.AD_Scans;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors;
with URV.Shared_Seals;
with URV.Shared_Status;
with URVOS;        use URVOS;
with URVOS.Bare_Nodes;
with URVOS.Starts; use URVOS.Starts;

generic
   Name            : String;
   AD_Board        : in out URV.AD_Boards.Board;
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;
   Sealing         : in out URV.Shared_Seals.Shared_Seal;
   CORE_Memory     : in out URV.Shared_CORE_Memory.Board;
   Node_Status     : in out URV.Shared_Status.Status;
   Errors          : in out URV.Shared_Errors.Shared_Log;

   with package Node is new URVOS.Bare_Nodes (<>);
   with procedure Begin_Start (Condition : Start_Condition);

   --  See URV.ADINT_Handler.
   with procedure Handle_End (Next : Successor; Value : Word);

   --  A clock tick of the boards that have a clock, and the output of the
   --  words that the tasks have written.
   with procedure Tick_Boards is null;
   with procedure Write_Outputs is null;

   --  For the emulator: the control laws on or off before the start, and the
   --  words of the outputs as text.
   with procedure Set_Laws (On : Boolean) is null;
   with procedure Put_Outputs is null;
package Node_Programs is

   --  An image has one instance.
   pragma Warnings (Off, "all instances of * same external name");

   --  Starts the node at power up.
   procedure Start with No_Return;

   --  Starts the node with its memory kept. Condition is 1 for the reset
   --  switch, 2 for a restart of the processor.
   procedure Run (Condition : Integer_32)
   with Export, Convention => C, External_Name => "urv_run", No_Return;

private

   procedure On_Tick
   with Export, Convention => C, External_Name => "urv_tick";

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

end Node_Programs;
