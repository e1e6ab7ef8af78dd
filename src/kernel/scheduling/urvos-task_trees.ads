--  SPDX-License-Identifier: Apache-2.0

--  The application's description of its tasks for the operating system
--  (report, section 3.2; KRN-1).
--
--  A task tree is a list of task headers. A null header or the last place ends
--  it. It has one place for each task control block, so no tree is too long.
--
--  The report's header holds the task's starting address. Here the
--  identification number replaces the address: the application runs the task
--  of a given number (D-40).

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

   --  A task with a higher number is chosen first.
   type Priority is range 0 .. 31;

   type Task_Header is record
      Id               : Task_Id  := No_Task;
      Start_Time       : Tick     := 0;
      Initial_Priority : Priority := 0;
   end record;

   Null_Header : constant Task_Header := (others => <>);

   type Task_Tree is array (TCB_Number) of Task_Header;

   Empty_Tree : constant Task_Tree := (others => (others => <>));

   --  No header up to this one is a null header.
   function Is_In_Tree
     (Tree  : Task_Tree;
      Which : TCB_Number) return Boolean
   is
     (for all Earlier in TCB_Number'First .. Which =>
        Tree (Earlier).Id /= No_Task)
   with Global => null;

   --  A node has one to four processors (D-46); the master has number 1. At
   --  each start each processor loads the tasks of its number (KRN-5, EXT-4,
   --  D-23).
   type Processor_Number is range 1 .. 4;

   --  The schedule of the tasks: the report's (FRM-2), or one in which each
   --  task follows closely after the task that feeds it (FRM-5).
   type Schedule_Name is (Report, Fast);

   --  A task's release within each major frame, and its processor among four.
   --  URVOS.Task_Lists deals the tasks to fewer.
   type Task_Place is record
      Offset    : Minor_Frame;
      Processor : Processor_Number;
   end record
   with Alignment => 2;

   --  A task's place in each schedule.
   type Task_Attributes is array (Schedule_Name) of Task_Place
   with Alignment => 2;

end URVOS.Task_Trees;
