--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Schedulers with SPARK_Mode is

   --  The one of two TCBs that is ahead, if Head is one. It is out of the
   --  loops: they are short and run often.
   function Better
     (S : Scheduler; Head : TCB_Count; Which : TCB_Number) return TCB_Number
   is
     (if Head = No_TCB or else Is_Ahead (S, Which, Head) then Which else Head)
   with
     No_Inline,
     Global => null;

   --  Head_Of for the ready queue, which is searched several times in each
   --  minor frame.
   function First_Ready (S : Scheduler) return TCB_Count
   with
     Global => null,
     Post   => Is_Head (S, Ready, First_Ready'Result);

   function First_Ready (S : Scheduler) return TCB_Count is
      Head : TCB_Count := No_TCB;
   begin
      for Which in TCB_Number loop
         pragma Assert
           (for all Other in TCB_Number =>
              (if Other /= Which
               then Is_Ahead (S, Other, Which) /= Is_Ahead (S, Which, Other)));
         if S.TCBs (Which).Id /= No_Task
           and then S.TCBs (Which).Ready_At <= S.Clock
           and then Which /= S.Running
         then
            Head := Better (S, Head, Which);
         end if;
         pragma Loop_Invariant (Is_Head (S, Ready, Head, Which));
      end loop;
      return Head;
   end First_Ready;

   function Head_Of (S : Scheduler; Queue : Queue_Name) return TCB_Count is
      Head : TCB_Count := No_TCB;
   begin
      if Queue = Ready then
         return First_Ready (S);
      end if;
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
