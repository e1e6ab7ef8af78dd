--  SPDX-License-Identifier: Apache-2.0

--  What the application tells the operating system of its tasks (report,
--  section 3.2; KRN-1).
--
--  A task tree is a list of task headers, ended by a null header or by its
--  last place. It has as many places as there are task control blocks, so
--  no tree is too long.
--
--  The report's header holds the task's starting address. Here the
--  identification number stands for it: the application runs the task of
--  that number when it is told to (D-40).

with URVOS.Frames; use URVOS.Frames;

package URVOS.Task_Trees with Pure, SPARK_Mode is

   Number_Of_TCBs : constant := 16;

   --  A task control block, or none.
   type TCB_Count is range 0 .. Number_Of_TCBs;

   No_TCB : constant TCB_Count := 0;

   subtype TCB_Number is TCB_Count range 1 .. Number_Of_TCBs;

   --  A task's number; 0 is no task.
   type Task_Id is range 0 .. 255;

   No_Task : constant Task_Id := 0;

   --  The higher, the sooner.
   type Priority is range 0 .. 31;

   type Task_Header is record
      Id               : Task_Id  := No_Task;
      Start_Time       : Tick     := 0;
      Initial_Priority : Priority := 0;
   end record;

   Null_Header : constant Task_Header := (others => <>);

   type Task_Tree is array (TCB_Number) of Task_Header;

   Empty_Tree : constant Task_Tree := (others => (others => <>));

   --  A header that has no null header at or before it.
   function Is_In_Tree
     (Tree  : Task_Tree;
      Which : TCB_Number) return Boolean
   is
     (for all Earlier in TCB_Number'First .. Which =>
        Tree (Earlier).Id /= No_Task)
   with Global => null;

   --  A node has one to four processors (D-46); the master is number 1. At
   --  each start each loads the tasks of its number (KRN-5, EXT-4, D-23).
   type Processor_Number is range 1 .. 4;

   --  When and where tasks run: as the report says (FRM-2), or so that what
   --  they pass on is soon where it belongs (FRM-5).
   type Schedule_Name is (Report, Fast);

   --  When a task is released in each major frame, and on which processor of
   --  four. URVOS.Task_Lists deals them to fewer.
   type Task_Place is record
      Offset    : Minor_Frame;
      Processor : Processor_Number;
   end record;

   --  What a node's list says of a task.
   type Task_Attributes is array (Schedule_Name) of Task_Place;

end URVOS.Task_Trees;
