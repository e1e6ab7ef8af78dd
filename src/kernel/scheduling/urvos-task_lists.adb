--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Task_Lists with SPARK_Mode is

   function Tree_Of
     (Processors : Processor_Number;
      Which      : Processor_Number;
      Now        : Clock_Tick;
      Schedule   : Schedule_Name := Report) return Task_Tree
   is
      Tree : Task_Tree := Empty_Tree;
      Last : Natural range 0 .. Number_Of_TCBs := 0;
   begin
      for Who in Task_Name loop
         if Processor_Of (Who, Processors, Schedule) = Which then
            Last := Last + 1;
            Tree (TCB_Number (Last)) := Header (Who, Now);
         end if;

         pragma Loop_Invariant
           (Last = Number_Up_To (Who, Processors, Which, Schedule));
         pragma Loop_Invariant
           (for all Earlier in Task_Name'First .. Who =>
              Number_Up_To (Earlier, Processors, Which, Schedule) <= Last);
         pragma Loop_Invariant
           (for all Earlier in Task_Name'First .. Who =>
              (if Processor_Of (Earlier, Processors, Schedule) = Which
               then Number_Up_To (Earlier, Processors, Which, Schedule) >= 1
                 and then Tree
                   (TCB_Number
                      (Number_Up_To
                         (Earlier, Processors, Which, Schedule))) =
                     Header (Earlier, Now)));
         pragma Loop_Invariant
           (for all Place in TCB_Number =>
              (if Natural (Place) > Last then Tree (Place) = Null_Header));
      end loop;
      return Tree;
   end Tree_Of;

end URVOS.Task_Lists;
