--  SPDX-License-Identifier: Apache-2.0

--  How states of a scheduler follow each other (KRN-1 to KRN-4): what its
--  calls say in their contracts.

package URVOS.Schedulers.Changes with Pure, SPARK_Mode, Ghost is

   --  Nothing about the task itself has changed, but which queue its TCB is
   --  in and whether it has run.
   function Is_Same_Task
     (Before, After : Scheduler;
      Which         : TCB_Number) return Boolean
   is
     (Id_Of (After, Which) = Id_Of (Before, Which)
      and then Priority_Of (After, Which) = Priority_Of (Before, Which)
      and then Release_Of (After, Which) = Release_Of (Before, Which))
   with
     Global   => null,
     Annotate => (GNATprove, Inline_For_Proof);

   --  Neither its queue nor anything else has changed.
   function Is_Unchanged
     (Before, After : Scheduler;
      Which         : TCB_Number) return Boolean
   is
     (Is_Same_Task (Before, After, Which)
      and then Queue_Of (After, Which) = Queue_Of (Before, Which)
      and then Is_New_Release (After, Which) = Is_New_Release (Before, Which)
      and then Is_First_Run (After, Which) = Is_First_Run (Before, Which))
   with
     Global   => null,
     Annotate => (GNATprove, Inline_For_Proof);

   --  Nothing has changed at all.
   function Is_The_Same (Before, After : Scheduler) return Boolean is
     (After = Before
      and then
        (for all Which in TCB_Number => Is_Unchanged (Before, After, Which))
      and then
        (for all A in TCB_Number =>
           (for all B in TCB_Number =>
              Is_Ahead (After, A, B) = Is_Ahead (Before, A, B))))
   with Global => null;

   --  Among all but one, those that share a queue stand as they stood.
   function Order_Is_Kept
     (Before, After : Scheduler;
      Except        : TCB_Number) return Boolean
   is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           (if A /= Except and then B /= Except
              and then Queue_Of (After, A) = Queue_Of (After, B)
              and then Queue_Of (Before, A) = Queue_Of (Before, B)
            then Is_Ahead (After, A, B) = Is_Ahead (Before, A, B))))
   with Global => null;

   --  The task is the one to be chosen from the ready queue: of the highest
   --  priority, and of several such the one that came first.
   function Is_Best_Ready
     (S     : Scheduler;
      Which : TCB_Number) return Boolean
   is
     (Queue_Of (S, Which) = Ready
      and then
        (for all Other in TCB_Number =>
           (if Other /= Which and then Queue_Of (S, Other) = Ready
            then Priority_Of (S, Which) > Priority_Of (S, Other)
              or else
                (Priority_Of (S, Which) = Priority_Of (S, Other)
                 and then Is_Ahead (S, Which, Other)))))
   with Global => null;

   --  Each queue is in its order, and equals in that of their numbers.
   function Equals_Are_In_Turn (S : Scheduler) return Boolean is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           (if Queue_Of (S, A) = Queue_Of (S, B)
            then Is_Ahead (S, A, B) =
              (case Queue_Of (S, A) is
                  when Ready          =>
                     Priority_Of (S, A) > Priority_Of (S, B)
                     or else
                       (Priority_Of (S, A) = Priority_Of (S, B)
                        and then A < B),
                  when Timer          =>
                     Release_Of (S, A) < Release_Of (S, B)
                     or else
                       (Release_Of (S, A) = Release_Of (S, B)
                        and then A < B),
                  when Running | Free => A < B))))
   with Global => null;

   --  The best ready task runs, and the caller is in the ready queue, behind
   --  those of its own priority.
   function Is_Handed_Over
     (Before, After : Scheduler;
      Caller, Best  : TCB_Number) return Boolean
   is
     (Is_Best_Ready (Before, Best)
      and then
        (for all Which in TCB_Number =>
           Is_Same_Task (Before, After, Which)
           and then Is_First_Run (After, Which) = Is_First_Run (Before, Which)
           and then Is_New_Release (After, Which) =
             (Is_New_Release (Before, Which) and then Which /= Best)
           and then Queue_Of (After, Which) =
             (if Which = Best then Running
              elsif Which = Caller then Ready
              else Queue_Of (Before, Which)))
      and then
        (for all A in TCB_Number =>
           (for all B in TCB_Number =>
              (if A not in Best | Caller and then B not in Best | Caller
                 and then Queue_Of (After, A) = Queue_Of (After, B)
               then Is_Ahead (After, A, B) = Is_Ahead (Before, A, B))))
      and then
        (for all Other in TCB_Number =>
           (if Other /= Caller and then Queue_Of (After, Other) = Ready
            then Is_Ahead (After, Other, Caller) =
              (Priority_Of (After, Other) >= Priority_Of (After, Caller))))
      and then Overruns (After) =
        (if Is_New_Release (Before, Best)
           and then Release_Of (After, Best) < Clock (After)
         then Incremented (Overruns (Before))
         else Overruns (Before)))
   with Global => null;

end URVOS.Schedulers.Changes;
