--  SPDX-License-Identifier: Apache-2.0

--  The scheduler never loses or doubles a task, wakes none early or late, and
--  always runs a ready task of the highest priority, first come first served
--  among equals (report, sections 3.2 and 3.3; KRN-1 to KRN-4). This holds for
--  any tasks and any sequence of calls, on each processor. It does not limit
--  the time that a task takes; overruns are counted when they happen.
--
--  A TCB is in exactly one queue at any time, since Queue_Of has one result.
--  The result of a call depends only on the scheduler and the parameters,
--  since each call is a function.

with URVOS.Frames;     use URVOS.Frames;
with URVOS.Schedulers; use URVOS.Schedulers;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package Theorems.Scheduling with Pure, SPARK_Mode, Ghost is

   type Call_Kind is (Loads, Dispatches, Wakes, Exits, Sleeps, Terminates);

   --  A call of the scheduler with its parameters.
   type Scheduler_Call is record
      Kind       : Call_Kind;
      Header     : Task_Header;  --  of the task to load
      Now        : Clock_Tick;   --  at which the scheduler wakes
      Until_Tick : Tick;         --  the caller sleeps until it
   end record;

   type Call_Sequence is array (Positive range <>) of Scheduler_Call;

   --  The precondition of a call. In a sequence, a call that is not allowed
   --  does nothing.
   function Is_Allowed (S : Scheduler; Call : Scheduler_Call) return Boolean
   is
     (case Call.Kind is
         when Loads      =>
            Call.Header.Id /= No_Task and then Has_Free_TCB (S),
         when Dispatches => True,
         when Wakes      => Call.Now >= Clock (S),
         when Exits | Sleeps | Terminates => not Is_Idle (S))
   with Global => null;

   function After (S : Scheduler; Call : Scheduler_Call) return Scheduler is
     (if not Is_Allowed (S, Call) then S
      else
        (case Call.Kind is
            when Loads      => After_Load (S, Call.Header),
            when Dispatches => After_Dispatch (S),
            when Wakes      => After_Wake (S, Call.Now),
            when Exits      => After_Exit (S),
            when Sleeps     => After_Sleep (S, Call.Until_Tick),
            when Terminates => After_Terminate (S)))
   with Global => null;

   --  No task is lost or doubled

   --  The tasks are the same as before, each in its own TCB, with one
   --  exception.
   function Are_Kept
     (Before, After : Scheduler;
      Except        : TCB_Count := No_TCB) return Boolean
   is
     (for all Which in TCB_Number =>
        (if Which /= Except
         then (Queue_Of (After, Which) = Free) =
                (Queue_Of (Before, Which) = Free)
           and then TCB (After, Which).Id = TCB (Before, Which).Id
           and then TCB (After, Which).Priority =
                      TCB (Before, Which).Priority))
   with Global => null;

   --  A sleeping task sleeps on until its tick.
   function No_Task_Is_Woken_Early (Before, After : Scheduler) return Boolean
   is
     (for all Which in TCB_Number =>
        (if Queue_Of (Before, Which) = Timer
           and then Clock (After) < TCB (Before, Which).Ready_At
         then Queue_Of (After, Which) = Timer
           and then TCB (After, Which).Ready_At =
                      TCB (Before, Which).Ready_At))
   with Global => null;

   --  A task sleeps no longer than until its release. By Queue_Of it is in the
   --  timer queue exactly while Ready_At has not come.
   function Sleepers_Wait_For_Release (S : Scheduler) return Boolean is
     (for all Which in TCB_Number =>
        (if Queue_Of (S, Which) = Timer
         then TCB (S, Which).Release = TCB (S, Which).Ready_At
           and then TCB (S, Which).Release > Clock (S)))
   with Global => null;

   --  One call. Only LOAD takes a TCB, the first free one. Only TERMINATE
   --  frees one, the caller's. Every other task keeps its own. No task is
   --  woken early or late.
   procedure One_Call (S : Scheduler; Call : Scheduler_Call)
   with
     Global => null,
     Post   =>
       Clock (After (S, Call)) >= Clock (S)
       and then No_Task_Is_Woken_Early (S, After (S, Call))
       and then
         (if Sleepers_Wait_For_Release (S)
          then Sleepers_Wait_For_Release (After (S, Call)))
       and then
         (if Is_Allowed (S, Call) and then Call.Kind = Loads
          then Are_Kept (S, After (S, Call), Except => Head_Of (S, Free))
            and then Queue_Of (After (S, Call), Head_Of (S, Free)) /= Free
            and then TCB (After (S, Call), Head_Of (S, Free)).Id =
                       Call.Header.Id
          elsif Is_Allowed (S, Call) and then Call.Kind = Terminates
          then Are_Kept (S, After (S, Call), Except => Running_TCB (S))
            and then Queue_Of (After (S, Call), Running_TCB (S)) = Free
          else Are_Kept (S, After (S, Call)));

   --  The scheduler after the first Number calls of a sequence.
   function After_All
     (S      : Scheduler;
      Calls  : Call_Sequence;
      Number : Natural) return Scheduler
   is
     (if Number = 0 then S
      else After (After_All (S, Calls, Number - 1), Calls (Number)))
   with
     Global             => null,
     Pre                =>
       Calls'First = 1 and then Number <= Calls'Length,
     Subprogram_Variant => (Decreases => Number);

   --  Any sequence of calls. Without LOAD and TERMINATE the tasks remain the
   --  same. A sleeping task is in the timer queue until its release, and no
   --  longer.
   procedure Any_Calls (S : Scheduler; Calls : Call_Sequence)
   with
     Global => null,
     Pre    => Calls'First = 1,
     Post   =>
       Clock (After_All (S, Calls, Calls'Length)) >= Clock (S)
       and then
         (if (for all Call of Calls => Call.Kind not in Loads | Terminates)
          then Are_Kept (S, After_All (S, Calls, Calls'Length)))
       and then
         No_Task_Is_Woken_Early (S, After_All (S, Calls, Calls'Length))
       and then
         (if Sleepers_Wait_For_Release (S)
          then Sleepers_Wait_For_Release
                 (After_All (S, Calls, Calls'Length)));

   --  A start: each header has its TCB, with a task that is due or sleeps.
   procedure Start_Loads_The_Tree (Tree : Task_Tree; Now : Clock_Tick)
   with
     Global => null,
     Post   =>
       Are_Kept
         (Loaded_Tree (Tree, Now), After_Dispatch (Loaded_Tree (Tree, Now)))
       and then
         Sleepers_Wait_For_Release (After_Dispatch (Loaded_Tree (Tree, Now)))
       and then
         (for all Which in TCB_Number =>
            (if Is_In_Tree (Tree, Which)
             then TCB (Loaded_Tree (Tree, Now), Which).Id = Tree (Which).Id
               and then TCB (Loaded_Tree (Tree, Now), Which).Priority =
                          Tree (Which).Initial_Priority
               and then TCB (Loaded_Tree (Tree, Now), Which).Release =
                          Tree (Which).Start_Time
               and then TCB (Loaded_Tree (Tree, Now), Which).First_Run
               and then Queue_Of (Loaded_Tree (Tree, Now), Which) =
                 (if Tree (Which).Start_Time <= Now then Ready else Timer)
             else Queue_Of (Loaded_Tree (Tree, Now), Which) = Free));

   --  The best ready task runs

   --  No ready task has a higher priority than the running one.
   function Best_Runs (S : Scheduler) return Boolean is
     (for all Which in TCB_Number =>
        (if Queue_Of (S, Which) = Ready
         then TCB (S, Which).Priority <= TCB (S, Running_TCB (S)).Priority))
   with
     Global => null,
     Pre    => not Is_Idle (S);

   --  An idle processor gets the head of the ready queue, a task of the
   --  highest priority. It stays idle only if no task is ready.
   procedure Dispatch_Chooses_The_Best (S : Scheduler)
   with
     Global => null,
     Pre    => Is_Idle (S),
     Post   =>
       (if Is_Idle (After_Dispatch (S))
        then (for all Which in TCB_Number => Queue_Of (S, Which) /= Ready)
        else Best_Runs (After_Dispatch (S))
          and then Running_TCB (After_Dispatch (S)) = Head_Of (S, Ready));

   --  The same after EXIT, whether another task or the caller runs then.
   procedure Exit_Chooses_The_Best (S : Scheduler)
   with
     Global => null,
     Pre    => not Is_Idle (S),
     Post   =>
       not Is_Idle (After_Exit (S)) and then Best_Runs (After_Exit (S));

   --  First come, first served among equals

   --  The TCB follows all TCBs of its queue that have its priority.
   function Is_Behind_Equals
     (S : Scheduler; Which : TCB_Number) return Boolean
   is
     (for all Other in TCB_Number =>
        (if Other /= Which and then Queue_Of (S, Other) = Queue_Of (S, Which)
         then Is_Ahead (S, Other, Which) =
                (TCB (S, Other).Priority >= TCB (S, Which).Priority)))
   with Global => null;

   --  TCBs that share a queue keep their order, with one exception.
   function Order_Is_Kept
     (Before, After : Scheduler;
      Except        : TCB_Count := No_TCB) return Boolean
   is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           (if A /= Except and then B /= Except
              and then Queue_Of (After, A) = Queue_Of (After, B)
              and then Queue_Of (After, A) /= Running
            then Is_Ahead (After, A, B) = Is_Ahead (Before, A, B))))
   with Global => null;

   --  A task that becomes ready, or a TCB that becomes free, follows its
   --  equals. All others keep their order.
   procedure First_Come_First_Served (S : Scheduler; Call : Scheduler_Call)
   with
     Global => null,
     Pre    => Is_Allowed (S, Call),
     Post   =>
       (case Call.Kind is
           when Dispatches | Wakes =>
              Order_Is_Kept (S, After (S, Call)),
           when Loads =>
              Order_Is_Kept (S, After (S, Call), Head_Of (S, Free))
              and then
                (if Call.Header.Start_Time <= Clock (S)
                 then Is_Behind_Equals
                        (After (S, Call), Head_Of (S, Free))),
           when Exits =>
              After_Exit (S) = S
              or else
                (Order_Is_Kept (S, After (S, Call), Running_TCB (S))
                 and then Is_Behind_Equals (After (S, Call), Running_TCB (S))),
           when Sleeps =>
              Order_Is_Kept (S, After (S, Call), Running_TCB (S)),
           when Terminates =>
              Order_Is_Kept (S, After (S, Call), Running_TCB (S))
              and then Is_Behind_Equals (After (S, Call), Running_TCB (S)));

   --  Sleeping tasks are woken in the order of their ticks, after ready tasks
   --  of the same priority.
   procedure Sleepers_Wake_In_Order (S : Scheduler; Now : Clock_Tick)
   with
     Global => null,
     Pre    => Now >= Clock (S),
     Post   =>
       (for all A in TCB_Number =>
          (for all B in TCB_Number =>
             (if Queue_Of (After_Wake (S, Now), A) = Ready
                and then Queue_Of (S, B) = Timer
                and then TCB (S, A).Priority = TCB (S, B).Priority
                and then
                  (Queue_Of (S, A) = Ready
                   or else TCB (S, A).Ready_At < TCB (S, B).Ready_At)
              then Is_Ahead (After_Wake (S, Now), A, B))));

end Theorems.Scheduling;
