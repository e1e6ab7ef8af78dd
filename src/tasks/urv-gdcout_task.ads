--  SPDX-License-Identifier: Apache-2.0

--  GDCOUT task: gives the sticks to CORE and to the aircraft (report, 5.6,
--  table 10; GDO-1, D-3, D-14). Released at minor frame 1 of the report's
--  schedule.
--
--  Consumes AD_variable, produces uplink_variable and TELOUT_variable. A frame
--  without a new image passes on the last data, marked as old. The node's own
--  bits are added to the error/status word (TST-4). A console order of another
--  kind replaces the commands on the uplink (EXT-2).
--
--  Each channel's word goes to the item of its type code. A channel with an
--  unknown code is reported, and its word is discarded (EXT-2).

with URV.Mailboxes;     use URV.Mailboxes;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Status; use URV.Shared_Status;
with URV.Type_Codes;    use URV.Type_Codes;

generic
   AD_Variable     : in out For_Stick_Images.Variable;
   Uplink_Variable : in out For_Uplink.Variable;
   TELOUT_Variable : in out For_Uplink.Variable;
   Console_Orders  : in out For_Uplink.Variable;
   Node_Status     : in out Status;
   Errors          : in out Shared_Log;
   Codes           : Channel_Codes;
package URV.GDCOUT_Task with SPARK_Mode is

   procedure Run_Transaction
   with
     Global =>
       (Input  => Node_Status,
        In_Out => (AD_Variable, Uplink_Variable, TELOUT_Variable,
                   Console_Orders, Errors));

end URV.GDCOUT_Task;
