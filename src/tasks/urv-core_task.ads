--  SPDX-License-Identifier: Apache-2.0

--  CORE task: keeps the node's CORE memory up to date (report, 4.3, table 3;
--  COR-1). Released at minor frame 4 of the report's schedule.
--
--  Consumes uplink_variable and downlink_variable, produces the CORE uplink
--  and downlink areas, the latter with the downlink's frame (FTI-12). It
--  writes only messages of this frame. It writes the type codes when it first
--  runs (INI-7).
--
--  Each word goes to the place of its type code in the area (EXT-2). A place
--  with an unknown code is not written but reported; all codes are written
--  again in the next frame.

with URVOS.Shared_Data;
with URV.Mailboxes;          use URV.Mailboxes;
with URV.Shared_CORE_Memory; use URV.Shared_CORE_Memory;
with URV.Shared_Errors;      use URV.Shared_Errors;

generic
   Uplink_Variable   : in out For_Uplink.Variable;
   Downlink_Variable : in out For_Framed_Downlink.Variable;
   CORE_Memory       : in out Board;
   Errors            : in out Shared_Log;
package URV.CORE_Task with SPARK_Mode is

   package Flags is new URVOS.Shared_Data (Boolean, Initial => True);

   --  The type codes must still be written.
   Codes_Wanted : Flags.Store;

   procedure Initialise
   with Global => (In_Out => Codes_Wanted);

   procedure Run_Transaction
   with
     Global =>
       (In_Out => (Codes_Wanted, Uplink_Variable, Downlink_Variable,
                   CORE_Memory, Errors));

end URV.CORE_Task;
