--  SPDX-License-Identifier: Apache-2.0

--  Self-test task: checks the program memory in flight (report, 2.4; TST-3,
--  TST-4). Released at minor frame 6, with the lowest priority.
--
--  Consumes Bytes_Per_Frame bytes of the program memory in each major frame,
--  and produces the result of each pass in CORE's status. A difference sets
--  the node's bit of the error/status word. The task only reads, and its work
--  is the same in each frame. An image of 64 KiB takes 1024 frames at 64
--  bytes, which is 20.48 s.

with URVOS;             use URVOS;
with URVOS.Memories;    use URVOS.Memories;
with URVOS.ROM_Checks;
with URVOS.Shared_Data;
with URV.Shared_CORE_Memory;
with URV.Shared_Errors; use URV.Shared_Errors;
with URV.Shared_Status; use URV.Shared_Status;

generic
   --  The last byte of the image.
   Last : Byte_Address;

   Bytes_Per_Frame : Positive;

   CORE_Memory : in out URV.Shared_CORE_Memory.Board;
   Node_Status : in out Status;
   Errors      : in out Shared_Log;

   with procedure Read_ROM (Where : Byte_Address; Data : out Byte);
package URV.Self_Test_Task with SPARK_Mode is

   package Checks is new URVOS.ROM_Checks (Last);

   package Stores is
     new URVOS.Shared_Data (Checks.Check, Checks.New_Check);

   Progress : Stores.Store;

   --  Restarts at the first byte, with all counts 0.
   procedure Initialise
   with Global => (In_Out => Progress);

   procedure Run_Transaction;

end URV.Self_Test_Task;
