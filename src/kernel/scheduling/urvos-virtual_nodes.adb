--  SPDX-License-Identifier: Apache-2.0

with URVOS.Executives;
with URVOS.Start_Orders; use URVOS.Start_Orders;

package body URVOS.Virtual_Nodes with SPARK_Mode is

   package Processor_1 is
     new URVOS.Executives (Software.Step, Software.Report_Overrun);

   package Processor_2 is
     new URVOS.Executives (Software.Step, Software.Report_Overrun);

   package Processor_3 is
     new URVOS.Executives (Software.Step, Software.Report_Overrun);

   package Processor_4 is
     new URVOS.Executives (Software.Step, Software.Report_Overrun);

   --  The last processor that the node has.
   Last : Seat := Master;

   procedure Load (Which : Seat; Tree : Task_Tree; Now : Clock_Tick);

   procedure Tick (Which : Seat; Now : Clock_Tick);

   procedure Run (Which : Seat);

   procedure Load (Which : Seat; Tree : Task_Tree; Now : Clock_Tick) is
   begin
      case Which is
         when 1 => Processor_1.Start (Tree, Now);
         when 2 => Processor_2.Start (Tree, Now);
         when 3 => Processor_3.Start (Tree, Now);
         when 4 => Processor_4.Start (Tree, Now);
      end case;
   end Load;

   procedure Tick (Which : Seat; Now : Clock_Tick) is
   begin
      case Which is
         when 1 => Processor_1.Clock_Interrupt (Now);
         when 2 => Processor_2.Clock_Interrupt (Now);
         when 3 => Processor_3.Clock_Interrupt (Now);
         when 4 => Processor_4.Clock_Interrupt (Now);
      end case;
   end Tick;

   procedure Run (Which : Seat) is
   begin
      case Which is
         when 1 => Processor_1.Run_Until_Idle;
         when 2 => Processor_2.Run_Until_Idle;
         when 3 => Processor_3.Run_Until_Idle;
         when 4 => Processor_4.Run_Until_Idle;
      end case;
   end Run;

   procedure Start
     (Condition  : Start_Condition;
      Now        : Clock_Tick;
      Processors : Processor_Number := 1;
      Schedule   : Schedule_Name    := Report)
   is
      Passed  : Boolean;
      Numbers : Number_List;
   begin
      Last := Seat (Processors);
      Software.Begin_Again (Condition, Now, Passed);

      --  All processors have stopped; the master gives them their numbers.
      Numbers := Numbers_For ((for Which in Seat => Which <= Last));
      for Which in Master .. Last loop
         Load
           (Which,
            (if Passed
             then Software.Tasks.Tree_Of
                (Processors, Numbers (Which), Now, Schedule)
             else Empty_Tree),
            Now);
      end loop;
      Look_Again;
   end Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      Software.Set_Time (Now);
      for Which in Master .. Last loop
         Tick (Which, Now);
         Run (Which);
      end loop;
   end Clock_Interrupt;

   procedure Look_Again is
   begin
      for Which in Master .. Last loop
         Run (Which);
      end loop;
   end Look_Again;

   function Overruns return Count is
     (Saturating_Sum
        (Saturating_Sum (Processor_1.Overruns, Processor_2.Overruns),
         Saturating_Sum (Processor_3.Overruns, Processor_4.Overruns)));

end URVOS.Virtual_Nodes;
