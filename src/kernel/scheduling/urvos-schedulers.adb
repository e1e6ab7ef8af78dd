--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Schedulers with SPARK_Mode is

   function Head_Of (S : Scheduler; Queue : Queue_Name) return TCB_Count is
      Head : TCB_Count := No_TCB;
   begin
      for Which in TCB_Number loop
         pragma Assert
           (for all Other in TCB_Number =>
              (if Other /= Which
               then Is_Ahead (S, Other, Which) /= Is_Ahead (S, Which, Other)));
         if Queue_Of (S, Which) = Queue
           and then (Head = No_TCB or else Is_Ahead (S, Which, Head))
         then
            Head := Which;
         end if;
         pragma Loop_Invariant (Is_Head (S, Queue, Head, Which));
      end loop;
      return Head;
   end Head_Of;

end URVOS.Schedulers;
