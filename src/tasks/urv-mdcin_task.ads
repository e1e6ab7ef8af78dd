--  SPDX-License-Identifier: Apache-2.0

--  MDCIN task: gives the ground's messages to CORE and the laws (report, 4.6,
--  table 6; MDI-1, D-11, D-14). Released at minor frame 1 of the report's
--  schedule.
--
--  Consumes TELIN_variable, produces uplink_variable and commands_variable. A
--  frame without a new message passes on the last one, marked as old.
--
--  A configuration and a test card go to the laws (EXT-2, FTI-1), a request
--  for rows to the recorder's sender (FTI-10). A block of any other kind is
--  reported and discarded. In all these cases CORE and the laws get the last
--  message, marked as old.

with URVOS.Shared_Data;
with URV.Buffers;       use URV.Buffers;
with URV.Mailboxes;     use URV.Mailboxes;
with URV.Shared_Errors; use URV.Shared_Errors;

generic
   TELIN_Variable         : in out For_Uplink.Variable;
   Uplink_Variable        : in out For_Uplink.Variable;
   Commands_Variable      : in out For_Uplink.Variable;
   Configuration_Variable : in out For_Uplink.Variable;
   Recorder_Requests      : in out For_Uplink.Variable;
   Errors                 : in out Shared_Log;
package URV.MDCIN_Task with SPARK_Mode is

   package Stores is new URVOS.Shared_Data (Uplink_Buffer, Neutral_Uplink);

   --  The last message for CORE and the laws. It survives a warm start and is
   --  neutral after a cold start.
   Previous : Stores.Store;

   procedure Reset
   with Global => (In_Out => Previous);

   procedure Run_Transaction
   with
     Global =>
       (In_Out => (Previous, TELIN_Variable, Uplink_Variable,
                   Commands_Variable, Configuration_Variable,
                   Recorder_Requests, Errors));

end URV.MDCIN_Task;
