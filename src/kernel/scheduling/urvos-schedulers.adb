--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Schedulers with SPARK_Mode is

   --  The ready queue has one head.
   procedure Prove_One_Head (S : Scheduler; One, Other : TCB_Count)
   with
     Ghost,
     Global => null,
     Pre    => Is_Head (S, Ready, One) and then Is_Head (S, Ready, Other),
     Post   => One = Other;

   --  The one of two TCBs that is ahead, if Head is one. It is out of the
   --  loop, which is short and runs often.
   function Better
     (S : Scheduler; Head : TCB_Count; Which : TCB_Number) return TCB_Number
   is
     (if Head = No_TCB or else Is_Ahead (S, Which, Head) then Which else Head)
   with
     No_Inline,
     Global => null;

   procedure Prove_One_Head (S : Scheduler; One, Other : TCB_Count) is
   begin
      if One /= No_TCB and then Other /= No_TCB and then One /= Other then
         pragma Assert (Is_Ahead (S, One, Other));
         pragma Assert (not Is_Ahead (S, Other, One));
      end if;
   end Prove_One_Head;

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

   procedure Find_Ready
     (S           : Scheduler;
      Head        : out TCB_Count;
      Others_Wait : out Boolean) is
   begin
      Head := No_TCB;
      Others_Wait := False;
      for Which in TCB_Number loop
         pragma Assert
           (for all Other in TCB_Number =>
              (if Other /= Which
               then Is_Ahead (S, Other, Which) /= Is_Ahead (S, Which, Other)));
         if S.TCBs (Which).Id /= No_Task
           and then S.TCBs (Which).Ready_At <= S.Clock
           and then Which /= S.Running
         then
            Others_Wait := Head /= No_TCB;
            Head := Better (S, Head, Which);
         end if;
         pragma Loop_Invariant (Is_Head (S, Ready, Head, Which));
         pragma Loop_Invariant
           (if not Others_Wait
            then (for all Place in 1 .. Which =>
                    (if Queue_Of (S, Place) = Ready then Place = Head)));
      end loop;
      Prove_One_Head (S, Head, Head_Of (S, Ready));
   end Find_Ready;

end URVOS.Schedulers;
