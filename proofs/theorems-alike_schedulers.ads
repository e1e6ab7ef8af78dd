--  SPDX-License-Identifier: Apache-2.0

--  When two schedulers cannot be told apart, and what follows of it. What
--  Theorems.Scheduler_Results says is said in these words (EVI-7).
--
--  Some functions here say what another one says, as one claim: a prover
--  that is to find the claim of another scheduler does not look into it.

with URVOS;              use URVOS;
with URVOS.Arrangements; use URVOS.Arrangements;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Schedulers;   use URVOS.Schedulers;

with URVOS.Schedulers.Changes; use URVOS.Schedulers.Changes;

package Theorems.Alike_Schedulers with Pure, SPARK_Mode, Ghost is

   --  The queues of both stand in the same order.
   function Orders_Are_Alike (One, Other : Scheduler) return Boolean is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           (if Queue_Of (One, A) = Queue_Of (One, B)
            then Is_Ahead (One, A, B) = Is_Ahead (Other, A, B))))
   with Global => null;

   --  All else is the same. Of a free TCB nothing counts but its place in the
   --  queue: the next task to be loaded overwrites it.
   function Tasks_Are_Alike (One, Other : Scheduler) return Boolean is
     (Clock (One) = Clock (Other)
      and then Overruns (One) = Overruns (Other)
      and then Is_Idle (One) = Is_Idle (Other)
      and then
        (for all Which in TCB_Number =>
           Queue_Of (One, Which) = Queue_Of (Other, Which)
           and then
             (if Queue_Of (One, Which) /= Free
              then Is_Unchanged (One, Other, Which))))
   with
     Global   => null,
     Annotate => (GNATprove, Inline_For_Proof);

   --  Two schedulers that cannot be told apart.
   function Answers_Are_Alike (One, Other : Scheduler) return Boolean is
     (Tasks_Are_Alike (One, Other) and then Orders_Are_Alike (One, Other))
   with Global => null;

   function Are_Alike (One, Other : Scheduler) return Boolean is
     (Answers_Are_Alike (One, Other))
   with Global => null;

   --  Both are still what they were.
   procedure Prove_Still_Alike
     (One_Before, One, Other_Before, Other : Scheduler)
   with
     Global => null,
     Pre    =>
       Are_Alike (One_Before, Other_Before)
       and then Is_The_Same (One_Before, One)
       and then Is_The_Same (Other_Before, Other),
     Post   => Are_Alike (One, Other);

   --  Of two TCBs one is ahead.
   function Places_Differ (S : Scheduler) return Boolean is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           Is_Ahead (S, A, B) = (A /= B and then not Is_Ahead (S, B, A))))
   with Global => null;

   function One_Is_Ahead (S : Scheduler) return Boolean is
     (Places_Differ (S))
   with Global => null;

   procedure Prove_One_Is_Ahead (S : Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S),
     Post   => One_Is_Ahead (S);

   --  Who is ready is ahead of who sleeps.
   procedure Prove_Sleepers_Are_Behind (S : Scheduler)
   with
     Global => null,
     Post   =>
       (for all A in TCB_Number =>
          (for all B in TCB_Number =>
             (if Queue_Of (S, A) = Ready and then Queue_Of (S, B) = Timer
              then Is_Ahead (S, A, B) and then not Is_Ahead (S, B, A))));

   function Is_The_Best (S : Scheduler; Which : TCB_Number) return Boolean is
     (Is_Best_Ready (S, Which))
   with Global => null;

   --  There is one best.
   procedure Prove_One_Best (S : Scheduler; A, B : TCB_Number)
   with
     Global => null,
     Pre    =>
       One_Is_Ahead (S)
       and then Is_The_Best (S, A)
       and then Is_The_Best (S, B),
     Post   => A = B;

   --  Among all but one, those that share a queue stand in the same order.
   function Others_Are_Alike
     (One, Other : Scheduler;
      Except     : TCB_Number) return Boolean
   is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           (if A /= Except and then B /= Except
              and then Queue_Of (One, A) = Queue_Of (One, B)
            then Is_Ahead (One, A, B) = Is_Ahead (Other, A, B))))
   with
     Global   => null,
     Annotate => (GNATprove, Inline_For_Proof);

   --  The queues are the same in both, of all but one.
   function Others_Stay
     (One, Other : Scheduler;
      Except     : TCB_Number) return Boolean
   is
     (for all Which in TCB_Number =>
        (if Which /= Except
         then Queue_Of (One, Which) = Queue_Of (Other, Which)))
   with
     Global   => null,
     Annotate => (GNATprove, Inline_For_Proof);

   --  A TCB stands in both behind the same.
   function Stands_Alike
     (One, Other : Scheduler;
      Which      : TCB_Number) return Boolean
   is
     (for all Each in TCB_Number =>
        (if Each /= Which and then Queue_Of (One, Each) = Queue_Of (One, Which)
         then Is_Ahead (One, Each, Which) = Is_Ahead (Other, Each, Which)))
   with
     Global   => null,
     Annotate => (GNATprove, Inline_For_Proof);

   --  The same TCB has changed its queue in two schedulers, and stands in
   --  both behind the same.

   procedure Prove_Orders_Are_Alike
     (One, Other : Scheduler;
      Moved      : TCB_Number)
   with
     Global => null,
     Pre    =>
       Is_Sound (One)
       and then Is_Sound (Other)
       and then Others_Are_Alike (One, Other, Except => Moved)
       and then Stands_Alike (One, Other, Moved),
     Post   => Orders_Are_Alike (One, Other);

   procedure Prove_Still_Alike_But
     (One_Before, One, Other_Before, Other : Scheduler;
      Moved                                : TCB_Number)
   with
     Global => null,
     Pre    =>
       Is_Sound (One)
       and then Is_Sound (Other)
       and then Are_Alike (One_Before, Other_Before)
       and then Order_Is_Kept (One_Before, One, Except => Moved)
       and then Order_Is_Kept (Other_Before, Other, Except => Moved)
       and then Others_Stay (One_Before, One, Except => Moved)
       and then Others_Stay (Other_Before, Other, Except => Moved)
       and then Tasks_Are_Alike (One, Other)
       and then Stands_Alike (One, Other, Moved),
     Post   => Are_Alike (One, Other);

   function Has_Handed_Over
     (Before, After : Scheduler;
      Caller, Best  : TCB_Number) return Boolean
   is
     (Is_Handed_Over (Before, After, Caller, Best))
   with Global => null;

   --  The processor has been handed over. Who had no part in it stands as it
   --  stood.
   procedure Prove_Others_Wait
     (Before, After : Scheduler;
      Caller, Best  : TCB_Number)
   with
     Global => null,
     Pre    => Has_Handed_Over (Before, After, Caller, Best),
     Post   =>
       Is_The_Best (Before, Best)
       and then
         (for all Which in TCB_Number =>
            Queue_Of (After, Which) =
              (if Which = Best then Running
               elsif Which = Caller then Ready
               else Queue_Of (Before, Which)))
       and then
         (for all A in TCB_Number =>
            (for all B in TCB_Number =>
               (if A not in Best | Caller and then B not in Best | Caller
                  and then Queue_Of (After, A) = Queue_Of (After, B)
                then Is_Ahead (After, A, B) = Is_Ahead (Before, A, B))));

   --  So it has in both, between the same two.
   procedure Prove_Others_Wait_Alike
     (One_Before, One, Other_Before, Other : Scheduler;
      Caller, Best                         : TCB_Number)
   with
     Global => null,
     Pre    =>
       One_Is_Ahead (One)
       and then One_Is_Ahead (Other)
       and then Orders_Are_Alike (One_Before, Other_Before)
       and then Has_Handed_Over (One_Before, One, Caller, Best)
       and then Has_Handed_Over (Other_Before, Other, Caller, Best)
       and then
         (for all Which in TCB_Number =>
            Queue_Of (One_Before, Which) = Queue_Of (Other_Before, Which)
            and then (Queue_Of (One_Before, Which) = Running)
                     = (Which = Caller)),
     Post   => Others_Are_Alike (One, Other, Except => Caller);

   --  Who stands in turn stands alike.
   procedure Prove_Turns_Are_Alike (One, Other : Scheduler)
   with
     Global => null,
     Pre    =>
       Equals_Are_In_Turn (One)
       and then Equals_Are_In_Turn (Other)
       and then
         (for all Which in TCB_Number =>
            Queue_Of (One, Which) = Queue_Of (Other, Which)
            and then
              (if Queue_Of (One, Which) /= Free
               then Is_Same_Task (One, Other, Which))),
     Post   => Orders_Are_Alike (One, Other);

end Theorems.Alike_Schedulers;
