--  SPDX-License-Identifier: Apache-2.0

--  AD task: hands on the scan of the last frame and begins the next one
--  (report, 4.1, table 1; AD-1). Released at minor frame 0.
--
--  Consumes ADINT_variable, produces AD_variable. A frame without a scan
--  passes on the words of the one before, with the error word set.

with URVOS.Shared_Mailboxes;
with URV.AD_Scans;      use URV.AD_Scans;
with URV.Buffers;       use URV.Buffers;
with URV.Shared_Errors; use URV.Shared_Errors;

generic
   with package Words is
     new URVOS.Shared_Mailboxes (Message => Channel_Words, others => <>);
   with package Images is
     new URVOS.Shared_Mailboxes (Message => AD_Image, others => <>);
   ADINT_Variable : in out Words.Variable;
   AD_Variable    : in out Images.Variable;
   Errors         : in out Shared_Log;
   with procedure Begin_Scan (Reached : out Channel_Count);
package URV.AD_Task with SPARK_Mode is

   procedure Initialise;

   procedure Run_Transaction;

end URV.AD_Task;
