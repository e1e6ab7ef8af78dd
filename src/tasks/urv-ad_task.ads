--  SPDX-License-Identifier: Apache-2.0

--  AD task: sends on the scan of the last frame and begins the next (report,
--  4.1, table 1; AD-1). Released at minor frame 0 of the report's schedule.
--
--  Consumes ADINT_variable, produces AD_variable. A frame without a scan
--  passes on the last words, with the error word set.
--
--  In the fast schedule (FRM-5) it begins a scan and waits for it: RECV with a
--  wait of one tick. It makes up to Fast_Scans scans in a row, and sends on
--  the newest that ended within the tick. Its words are therefore less than a
--  tick old, and the consumers run at the same tick. A scan that ends later is
--  discarded.

with URVOS.Frames;          use URVOS.Frames;
with URVOS.Kernel_Calls;    use URVOS.Kernel_Calls;
with URVOS.Receive_Calls;
with URVOS.Shared_Data;
with URVOS.Shared_Mailboxes;
with URV.AD_Scans;          use URV.AD_Scans;
with URV.AD_Steps;          use URV.AD_Steps;
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

   --  The number of scans in a frame of the fast schedule.
   Fast_Scans : Scan_Count;
package URV.AD_Task with SPARK_Mode is

   --  The same number, for theorems.
   function Scans return Scan_Count is (Fast_Scans)
   with Ghost, Global => null;

   package Stores is new URVOS.Shared_Data (Progress, (others => <>));

   package Receiving is
     new URVOS.Receive_Calls (Words, ADINT_Variable);

   Present : Stores.Store;

   procedure Initialise;

   procedure Run_Transaction (Now : Clock_Tick);

   --  A task that waits for a scan ends its step with EXIT.
   procedure Await_Scan (Call : in out Kernel_Call)
   with Global => (Input => Present);

end URV.AD_Task;
