--  SPDX-License-Identifier: Apache-2.0

--  Self-test task: checks the program memory in flight (report, 2.4; TST-3,
--  TST-4). Released at minor frame 6 of the report's schedule, with the lowest
--  priority.
--
--  Consumes Longs_Per_Frame longs of the program memory in each major frame,
--  and produces the result of each pass in CORE's status. A difference sets
--  the node's bit of the error/status word. The task only reads, and its work
--  is the same in each frame. An image of 64 KiB takes 1024 frames at 16
--  longs, which is 20.48 s.

with URVOS;             use URVOS;
with URVOS.Memories;    use URVOS.Memories;
with URVOS.ROM_Checks;
with URVOS.Shared_Data;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Status; use URV.Shared_Status;

generic
   --  The last long of the image.
   Last : Long_Address;

   Longs_Per_Frame : Positive;

   CORE_Memory : in out URV.Shared_CORE_Memory.Board;
   Node_Status : in out Status;
   Errors      : in out Shared_Log;

   with procedure Read_ROM (Where : Byte_Address; Data : out Long);
package URV.Self_Test_Task with SPARK_Mode is

   package Checks is new URVOS.ROM_Checks (Last);

   package Stores is
     new URVOS.Shared_Data (Checks.Check, Checks.New_Check);

   Progress : Stores.Store;

   --  Restarts at the first long, with all counts 0.
   procedure Initialise
   with Global => (In_Out => Progress);

   procedure Run_Transaction;

end URV.Self_Test_Task;
