--  SPDX-License-Identifier: Apache-2.0

--  A node's program on a bare machine (BRD-1), in place of a host's
--  partitions. The main program of a node has one instance and exports the
--  handlers of targets.ads.

with Devices.Shared_AD_Board;
with Telemetry.Shared_Boards;
with URVOS;        use URVOS;
with URVOS.Bare_Nodes;
with URVOS.Starts; use URVOS.Starts;

generic
   Name            : String;
   AD_Board        : in out Devices.Shared_AD_Board.Board;
   Telemetry_Board : in out Telemetry.Shared_Boards.Shared_Board;

   with package Node is new URVOS.Bare_Nodes (<>);
   with procedure Begin_Start (Condition : Start_Condition);

   with procedure AD_Interrupt;

   --  A clock tick of the boards that have a clock, and the output of the
   --  words that the tasks have written.
   with procedure Tick_Boards is null;
   with procedure Write_Outputs is null;
package Node_Programs is

   procedure Run (Condition : Start_Condition) with No_Return;

   --  The handlers

   procedure On_Tick;

   procedure On_Character_Time;

   procedure On_Character (Data : Byte; Damaged : Boolean);

   procedure On_Free_Sender;

   procedure On_Converted (Value : Word);

   --  Writes the counts as a line of text.
   procedure Put_Counts;

end Node_Programs;
