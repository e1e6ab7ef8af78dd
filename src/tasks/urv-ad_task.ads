--  SPDX-License-Identifier: Apache-2.0

--  AD task: hands on the scan of the last frame and begins the next one
--  (report, 4.1, table 1; AD-1). Released at minor frame 0.
--
--  Consumes ADINT_variable, produces AD_variable. A frame without a scan
--  passes on the words of the one before, with the error word set.
--
--  In the fast schedule (FRM-5) it begins the scan, waits a minor frame, and
--  hands on that scan: its words are 2 ms old, not 20. A scan that ends
--  later is handed on by nobody.

with URVOS.Frames;          use URVOS.Frames;
with URVOS.Kernel_Calls;    use URVOS.Kernel_Calls;
with URVOS.Shared_Data;
with URVOS.Shared_Mailboxes;
with URV.AD_Scans;          use URV.AD_Scans;
with URV.Buffers;           use URV.Buffers;
with URV.Shared_Errors;     use URV.Shared_Errors;
with URV.Shared_Schedules;

generic
   with package Words is
     new URVOS.Shared_Mailboxes (Message => Channel_Words, others => <>);
   with package Images is
     new URVOS.Shared_Mailboxes (Message => AD_Image, others => <>);
   ADINT_Variable : in out Words.Variable;
   AD_Variable    : in out Images.Variable;
   Errors         : in out Shared_Log;
   Schedule       : in out URV.Shared_Schedules.Store;
   with procedure Begin_Scan (Reached : out Channel_Count);
package URV.AD_Task with SPARK_Mode is

   --  Of the fast schedule: the task waits for its scan; else, whether the
   --  last one was there in time.
   type Progress is (Had_Scan, Had_No_Scan, Scanning);

   package Stores is new URVOS.Shared_Data (Progress, Had_Scan);

   Doing : Stores.Store;

   procedure Initialise;

   procedure Run_Transaction;

   --  A task that waits for its scan sleeps for a minor frame instead.
   procedure Await_Scan (Now : Clock_Tick; Call : in out Kernel_Call)
   with Global => (Input => Doing);

end URV.AD_Task;
