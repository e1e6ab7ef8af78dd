--  The Ada task that runs one task of the node in real time: it waits for
--  its turn, makes one step, gives the processor away.

with URVOS.Frames; use URVOS.Frames;

generic
   --  The task's place in the major frame (FRM-2).
   Offset : Minor_Frame;

   with procedure Wait_For_Turn;
   with procedure Begin_Step (First_Run : out Boolean);

   --  The task's initialisation if it is its first run, else one
   --  transaction. Failed tells of an unexpected exception (KRN-6).
   with procedure Step (First_Run : Boolean; Failed : out Boolean);

   with procedure End_Step (Offset : Minor_Frame; Failed : Boolean);
package URVOS.Real_Time_Tasks with SPARK_Mode is

   task Runner;

end URVOS.Real_Time_Tasks;
