--  SPDX-License-Identifier: Apache-2.0

--  The list of a node's tasks (report, sections 2.2, 3.1 and 3.2; FRM-2,
--  FRM-5, SET-1, KRN-1, KRN-5, D-46). It is the one place that names the
--  tasks. Identifications, headers and task trees follow from it.
--
--  The names are in order of priority: the first has the highest. A table
--  without a row for a name does not compile. A list of more tasks than task
--  control blocks does not prove.

with URVOS.Frames;     use URVOS.Frames;
with URVOS.Task_Trees; use URVOS.Task_Trees;

generic
   type Task_Name is (<>);
   type Task_Table is array (Task_Name) of Task_Attributes;
   Table : Task_Table;
package URVOS.Task_Lists with SPARK_Mode is

   function Id_Of (Who : Task_Name) return Task_Id is
     (Task_Name'Pos (Who) + 1)
   with Global => null;

   function Is_Task (Id : Task_Id) return Boolean is
     (Id in Id_Of (Task_Name'First) .. Id_Of (Task_Name'Last))
   with Global => null;

   function Task_Of (Id : Task_Id) return Task_Name is
     (Task_Name'Val (Id - 1))
   with
     Global => null,
     Pre    => Is_Task (Id);

   --  The task's next release: its offset in the next major frame.
   function Next_Release_Of
     (Who      : Task_Name;
      Now      : Clock_Tick;
      Schedule : Schedule_Name := Report) return Tick
   is (Next_Release (Now, Table (Who) (Schedule).Offset))
   with Global => null;

   --  The header of a task that begins at once with its initialisation.
   function Header (Who : Task_Name; Now : Clock_Tick) return Task_Header is
     ((Id               => Id_Of (Who),
       Start_Time       => Now,
       Initial_Priority => Priority'Last - Task_Name'Pos (Who)))
   with Global => null;

   --  The processor that runs the task: the table's, counted round if the node
   --  has fewer. On two processors, 1 has the tasks of 1 and 3, and 2 those of
   --  2 and 4.
   function Processor_Of
     (Who        : Task_Name;
      Processors : Processor_Number;
      Schedule   : Schedule_Name := Report) return Processor_Number
   is ((Table (Who) (Schedule).Processor - 1) mod Processors + 1)
   with
     Global => null,
     Post   => Processor_Of'Result <= Processors;

   --  The number of tasks of processor Which among the names up to Who.
   function Number_Up_To
     (Who        : Task_Name;
      Processors : Processor_Number;
      Which      : Processor_Number;
      Schedule   : Schedule_Name := Report) return Natural
   is
     ((if Who = Task_Name'First then 0
       else Number_Up_To (Task_Name'Pred (Who), Processors, Which, Schedule))
      + (if Processor_Of (Who, Processors, Schedule) = Which then 1 else 0))
   with
     Ghost,
     Global             => null,
     Post               => Number_Up_To'Result <= Task_Name'Pos (Who) + 1,
     Subprogram_Variant => (Decreases => Task_Name'Pos (Who));

   --  The tree of a processor: each of its tasks once, in the order of the
   --  names, and no other task.
   function Tree_Of
     (Processors : Processor_Number;
      Which      : Processor_Number;
      Now        : Clock_Tick;
      Schedule   : Schedule_Name := Report) return Task_Tree
   with
     Global => null,
     Post   =>
       (for all Who in Task_Name =>
          (if Processor_Of (Who, Processors, Schedule) = Which
           then Tree_Of'Result
             (TCB_Number (Number_Up_To (Who, Processors, Which, Schedule))) =
               Header (Who, Now)))
       and then
         (for all Place in TCB_Number =>
            (if Natural (Place) >
               Number_Up_To (Task_Name'Last, Processors, Which, Schedule)
             then Tree_Of'Result (Place) = Null_Header));

end URVOS.Task_Lists;
