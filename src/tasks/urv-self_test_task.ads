--  Self-test task: checks the program memory in flight (report, 2.4; TST-3).
--  Released at minor frame 6, below all others in priority.
--
--  Consumes the program memory, Bytes_Per_Frame bytes a major frame, and
--  produces the result of each pass. It only reads, and a frame's work is
--  always the same. An image of 64 KiB takes 1024 frames at 64 bytes, which
--  is 20.48 s.

with URVOS;          use URVOS;
with URVOS.Memories; use URVOS.Memories;

generic
   --  The last byte of the image.
   Last : Byte_Address;

   Bytes_Per_Frame : Positive := 128;

   with procedure Read_ROM (Where : Byte_Address; Data : out Byte);

   --  A pass has ended: how many found the image right since the start, and
   --  how many found it wrong.
   with procedure Write_Result (Good_Passes, Bad_Passes : Count);

   --  A pass found the image wrong. Detail is how many have.
   with procedure Report_Failure (Detail : Word);
package URV.Self_Test_Task
  with
    SPARK_Mode,
    Abstract_State => Progress,
    Initializes    => Progress
is

   --  At the first byte, with nothing counted.
   procedure Initialise
   with Global => (Output => Progress);

   procedure Run_Transaction;

end URV.Self_Test_Task;
