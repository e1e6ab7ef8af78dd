--  SPDX-License-Identifier: Apache-2.0

with URVOS.Executives;

package body URVOS.Virtual_Nodes with SPARK_Mode is

   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call);

   --  A number that is no task's ceases at once.
   procedure Step
     (Who       : Task_Id;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call) is
   begin
      if Tasks.Is_Task (Who) then
         Run_Step (Tasks.Task_Of (Who), First_Run, Now, Call);
      else
         Call := (Name => Terminate_Call, others => <>);
      end if;
   end Step;

   package Processor_1 is new URVOS.Executives (Step, Report_Overrun);

   package Processor_2 is new URVOS.Executives (Step, Report_Overrun);

   procedure Start
     (Condition  : Start_Condition;
      Now        : Clock_Tick;
      Processors : Processor_Number := 1;
      Schedule   : Schedule_Name    := Report)
   is
      Passed : Boolean;
   begin
      Begin_Again (Condition, Now, Passed);
      if Passed then
         Processor_1.Start
           (Tasks.Tree_Of (Processors, 1, Now, Schedule), Now);
         Processor_2.Start
           (Tasks.Tree_Of (Processors, 2, Now, Schedule), Now);
      else
         Processor_1.Start (Empty_Tree, Now);
         Processor_2.Start (Empty_Tree, Now);
      end if;
      Processor_1.Run_Until_Idle;
      Processor_2.Run_Until_Idle;
   end Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      Tell_Time (Now);
      Processor_1.Clock_Interrupt (Now);
      Processor_1.Run_Until_Idle;
      Processor_2.Clock_Interrupt (Now);
      Processor_2.Run_Until_Idle;
   end Clock_Interrupt;

   procedure Look_Again is
   begin
      Processor_1.Run_Until_Idle;
      Processor_2.Run_Until_Idle;
   end Look_Again;

   function Overruns return Count is
     (Saturating_Sum (Processor_1.Overruns, Processor_2.Overruns));

end URVOS.Virtual_Nodes;
