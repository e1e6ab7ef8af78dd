--  SPDX-License-Identifier: Apache-2.0

--  Which task runs (report, sections 3.2 and 3.3; KRN-1 to KRN-4, FRM-4).
--
--  One scheduler is the task management of one processor: task control
--  blocks (TCBs) in a free, a ready and a timer queue, and the task that
--  runs. It works for any task tree. There is no preemption: the running
--  task gives the processor away by EXIT, SLEEP or TERMINATE.
--
--  The ready queue is ordered by priority, first come first served among
--  equals; the timer queue by the tick that a task sleeps until.

with URVOS.Arrangements; use URVOS.Arrangements;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

package URVOS.Schedulers with Pure, SPARK_Mode is

   type Scheduler is private;

   type Queue_Name is (Running, Ready, Timer, Free);

   --  What a scheduler is made of

   --  The queue that a TCB is in. Running is a queue of one at most.
   function Queue_Of (S : Scheduler; Which : TCB_Number) return Queue_Name
   with Global => null;

   --  Of two TCBs in the same queue: the first will leave it first. Who is
   --  ready is ahead of who sleeps, and both of who is free.
   function Is_Ahead
     (S            : Scheduler;
      First, Other : TCB_Number) return Boolean
   with Global => null;

   function Id_Of (S : Scheduler; Which : TCB_Number) return Task_Id
   with Global => null;

   function Priority_Of (S : Scheduler; Which : TCB_Number) return Priority
   with Global => null;

   --  The tick at which a task is released, or was last.
   function Release_Of (S : Scheduler; Which : TCB_Number) return Tick
   with Global => null;

   --  The task has not run since it was released.
   function Is_New_Release
     (S : Scheduler; Which : TCB_Number) return Boolean
   with Global => null;

   --  The task has not run since it was loaded: its initialisation is due.
   function Is_First_Run (S : Scheduler; Which : TCB_Number) return Boolean
   with Global => null;

   --  The time that the scheduler was last told.
   function Clock (S : Scheduler) return Clock_Tick
   with Global => null;

   --  How often a task was released late, or ran into its next release.
   function Overruns (S : Scheduler) return Count
   with Global => null;

   --  No task runs.
   function Is_Idle (S : Scheduler) return Boolean
   with Global => null;

   --  What holds at all times

   --  The queues are in order, and who sleeps is not due.
   function Is_Sound (S : Scheduler) return Boolean
   with Global => null;

   --  The processor is not idle while a task is ready.
   function Is_Settled (S : Scheduler) return Boolean is
     (if Is_Idle (S)
      then (for all Which in TCB_Number => Queue_Of (S, Which) /= Ready))
   with Ghost, Global => null;

   function Has_Free_TCB (S : Scheduler) return Boolean is
     (for some Which in TCB_Number => Queue_Of (S, Which) = Free)
   with Global => null;

   --  The TCB that the next task to be loaded is given: the first of the
   --  free queue.
   function Next_Free_TCB (S : Scheduler) return TCB_Number
   with
     Global => null,
     Pre    => Is_Sound (S) and then Has_Free_TCB (S),
     Post   =>
       Queue_Of (S, Next_Free_TCB'Result) = Free
       and then
         (for all Other in TCB_Number =>
            (if Other /= Next_Free_TCB'Result
               and then Queue_Of (S, Other) = Free
             then Is_Ahead (S, Next_Free_TCB'Result, Other)));

   --  The TCB of the running task.
   function Running_TCB (S : Scheduler) return TCB_Number
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Is_Idle (S),
     Post   =>
       (for all Which in TCB_Number =>
          (Queue_Of (S, Which) = Running)
          = (Which = Running_TCB'Result));

   --  A ready task has a higher priority than the running one.
   function Has_Higher_Ready (S : Scheduler) return Boolean is
     (for some Which in TCB_Number =>
        Queue_Of (S, Which) = Ready
        and then Priority_Of (S, Which) > Priority_Of (S, Running_TCB (S)))
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Is_Idle (S);

   --  How states follow each other

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
     Ghost,
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
     Ghost,
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
   with Ghost, Global => null;

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
   with Ghost, Global => null;

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
   with Ghost, Global => null;

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
   with Ghost, Global => null;

   --  Starting

   --  All TCBs free.
   function Empty_Scheduler (Now : Clock_Tick) return Scheduler
   with
     Global => null,
     Post   =>
       Is_Sound (Empty_Scheduler'Result)
       and then Is_Idle (Empty_Scheduler'Result)
       and then Clock (Empty_Scheduler'Result) = Now
       and then Overruns (Empty_Scheduler'Result) = 0
       and then
         (for all Which in TCB_Number =>
            Queue_Of (Empty_Scheduler'Result, Which) = Free)
       and then
         (for all A in TCB_Number =>
            (for all B in TCB_Number =>
               Is_Ahead (Empty_Scheduler'Result, A, B) = (A < B)));

   --  Fills a TCB from a header, and puts it in the ready queue, or in the
   --  timer queue when its time has not come.
   procedure Load (S : in out Scheduler; Header : Task_Header)
   with
     Global => null,
     Pre    => Is_Sound (S) and then Has_Free_TCB (S),
     Post   =>
       Is_Sound (S)
       and then Clock (S) = Clock (S'Old)
       and then Overruns (S) = Overruns (S'Old)
       and then Is_Idle (S) = Is_Idle (S'Old)
       and then
         (for all Which in TCB_Number =>
            (if Which = Next_Free_TCB (S'Old)
             then Id_Of (S, Which) = Header.Id
               and then Priority_Of (S, Which) = Header.Initial_Priority
               and then Release_Of (S, Which) = Header.Start_Time
               and then Is_New_Release (S, Which)
               and then Is_First_Run (S, Which)
               and then Queue_Of (S'Old, Which) = Free
               and then Queue_Of (S, Which) =
                 (if Header.Start_Time <= Clock (S) then Ready else Timer)
             else Is_Unchanged (S'Old, S, Which)))
       and then Order_Is_Kept (S'Old, S, Except => Next_Free_TCB (S'Old))

       --  It stands behind those of its priority, or of its tick.
       and then
         (for all Other in TCB_Number =>
            (if Other /= Next_Free_TCB (S'Old)
               and then Queue_Of (S, Other) =
                          Queue_Of (S, Next_Free_TCB (S'Old))
             then Is_Ahead (S, Other, Next_Free_TCB (S'Old)) =
               (if Queue_Of (S, Other) = Ready
                then Priority_Of (S, Other) >= Header.Initial_Priority
                else Release_Of (S, Other) <= Header.Start_Time)));

   --  Gives an idle processor to the best ready task, if there is one. A
   --  task that gets it after the tick of its release has overrun.
   procedure Dispatch (S : in out Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S),
     Post   =>
       Is_Sound (S)
       and then Is_Settled (S)
       and then Clock (S) = Clock (S'Old)
       and then
         (if not Is_Idle (S'Old) or else Is_Settled (S'Old)
          then Is_The_Same (S'Old, S)
          else not Is_Idle (S)
            and then Is_Best_Ready (S'Old, Running_TCB (S))
            and then Is_Same_Task (S'Old, S, Running_TCB (S))
            and then not Is_New_Release (S, Running_TCB (S))
            and then Is_First_Run (S, Running_TCB (S)) =
                       Is_First_Run (S'Old, Running_TCB (S))
            and then
              (for all Which in TCB_Number =>
                 (if Which /= Running_TCB (S)
                  then Is_Unchanged (S'Old, S, Which)))
            and then Order_Is_Kept (S'Old, S, Except => Running_TCB (S))
            and then Overruns (S) =
              (if Is_New_Release (S'Old, Running_TCB (S))
                 and then Release_Of (S, Running_TCB (S)) < Clock (S)
               then Incremented (Overruns (S'Old))
               else Overruns (S'Old)));

   --  Starts the tasks of a tree: one TCB for each header, in their order,
   --  then the first task runs.
   procedure Start
     (S    : out Scheduler;
      Tree : Task_Tree;
      Now  : Clock_Tick)
   with
     Global => null,
     Post   =>
       Is_Sound (S)
       and then Is_Settled (S)
       and then Clock (S) = Now
       and then
         (for all Which in TCB_Number =>
            (if Is_In_Tree (Tree, Which)
             then Id_Of (S, Which) = Tree (Which).Id
               and then Priority_Of (S, Which) =
                          Tree (Which).Initial_Priority
               and then Release_Of (S, Which) = Tree (Which).Start_Time
               and then Is_New_Release (S, Which) =
                          (Queue_Of (S, Which) /= Running)
               and then Is_First_Run (S, Which)
               and then
                 (if Tree (Which).Start_Time <= Now
                  then Queue_Of (S, Which) in Ready | Running
                  else Queue_Of (S, Which) = Timer)
             else Queue_Of (S, Which) = Free))

       and then Equals_Are_In_Turn (S)

       --  Who runs is the first of the highest priority that are due.
       and then
         (if not Is_Idle (S)
          then (for all Which in TCB_Number =>
                  (if Queue_Of (S, Which) = Ready
                   then Priority_Of (S, Which) <
                          Priority_Of (S, Running_TCB (S))
                     or else
                       (Priority_Of (S, Which) =
                          Priority_Of (S, Running_TCB (S))
                        and then Which > Running_TCB (S)))))

       --  Who runs after its tick has overrun.
       and then Overruns (S) =
         (if not Is_Idle (S) and then Release_Of (S, Running_TCB (S)) < Now
          then 1
          else 0);

   --  The clock

   --  The time is now Now: who has slept long enough is ready, behind those
   --  of the same priority that were ready before, in the order of their
   --  ticks.
   procedure Wake (S : in out Scheduler; Now : Clock_Tick)
   with
     Global => null,
     Pre    => Is_Sound (S) and then Now >= Clock (S),
     Post   =>
       Is_Sound (S)
       and then Clock (S) = Now
       and then Overruns (S) = Overruns (S'Old)
       and then Is_Idle (S) = Is_Idle (S'Old)
       and then
         (for all Which in TCB_Number =>
            Is_Same_Task (S'Old, S, Which)
            and then Is_New_Release (S, Which) =
                       Is_New_Release (S'Old, Which)
            and then Is_First_Run (S, Which) = Is_First_Run (S'Old, Which)
            and then Queue_Of (S, Which) =
              (if Queue_Of (S'Old, Which) = Timer
                 and then Release_Of (S'Old, Which) <= Now
               then Ready
               else Queue_Of (S'Old, Which)))
       and then
         (for all A in TCB_Number =>
            (for all B in TCB_Number =>
               (if Queue_Of (S, A) = Ready and then Queue_Of (S, B) = Ready
                then Is_Ahead (S, A, B) =
                  (Priority_Of (S, A) > Priority_Of (S, B)
                   or else (Priority_Of (S, A) = Priority_Of (S, B)
                            and then Is_Ahead (S'Old, A, B))))))
       and then
         (for all A in TCB_Number =>
            (for all B in TCB_Number =>
               (if Queue_Of (S, A) = Queue_Of (S, B)
                  and then Queue_Of (S, A) in Timer | Free
                then Is_Ahead (S, A, B) = Is_Ahead (S'Old, A, B))));

   --  The calls of the running task

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
   with Ghost, Global => null;

   --  EXIT: the caller gives the processor to the best ready task, if one
   --  has a higher priority than its own, and goes behind those of its own
   --  in the ready queue. Else it runs on.
   procedure Exit_Call (S : in out Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Is_Idle (S),
     Post   =>
       Is_Sound (S)
       and then not Is_Idle (S)
       and then Clock (S) = Clock (S'Old)
       and then
         (if Has_Higher_Ready (S'Old)
          then Is_Handed_Over
                 (S'Old, S,
                  Caller => Running_TCB (S'Old),
                  Best   => Running_TCB (S))
          else Is_The_Same (S'Old, S));

   --  The tick that SLEEP makes of a request: a task that wants to sleep until
   --  a tick that has passed sleeps until the next one.
   function Wake_Up_Tick (Now : Clock_Tick; Until_Tick : Tick) return Tick is
     (if Until_Tick > Now then Until_Tick else Now + 1)
   with Global => null;

   --  The running task is still running although its next release, a major
   --  frame after the last one, has come.
   function Has_Overrun (S : Scheduler) return Boolean is
     (Clock (S) >= Ticks_Per_Major_Frame
      and then Release_Of (S, Running_TCB (S)) <=
                 Clock (S) - Ticks_Per_Major_Frame)
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Is_Idle (S);

   --  SLEEP: the caller waits in the timer queue, behind those of the same
   --  tick, and leaves an idle processor, see Dispatch.
   procedure Sleep (S : in out Scheduler; Until_Tick : Tick)
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Is_Idle (S),
     Post   =>
       Is_Sound (S)
       and then Is_Idle (S)
       and then Clock (S) = Clock (S'Old)
       and then Overruns (S) =
         (if Has_Overrun (S'Old)
          then Incremented (Overruns (S'Old))
          else Overruns (S'Old))
       and then
         (for all Which in TCB_Number =>
            (if Which = Running_TCB (S'Old)
             then Queue_Of (S, Which) = Timer
               and then Id_Of (S, Which) = Id_Of (S'Old, Which)
               and then Priority_Of (S, Which) = Priority_Of (S'Old, Which)
               and then Release_Of (S, Which) =
                          Wake_Up_Tick (Clock (S), Until_Tick)
               and then Is_New_Release (S, Which)
               and then not Is_First_Run (S, Which)
             else Is_Unchanged (S'Old, S, Which)))
       and then Order_Is_Kept (S'Old, S, Except => Running_TCB (S'Old))
       and then
         (for all Other in TCB_Number =>
            (if Other /= Running_TCB (S'Old)
               and then Queue_Of (S, Other) = Timer
             then Is_Ahead (S, Other, Running_TCB (S'Old)) =
               (Release_Of (S, Other) <=
                  Wake_Up_Tick (Clock (S), Until_Tick))));

   --  TERMINATE, or the end of a task's statements: the caller's TCB is
   --  free, the last to be used again, the processor idle, see Dispatch.
   procedure Terminate_Caller (S : in out Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Is_Idle (S),
     Post   =>
       Is_Sound (S)
       and then Is_Idle (S)
       and then Clock (S) = Clock (S'Old)
       and then Overruns (S) = Overruns (S'Old)
       and then
         (for all Which in TCB_Number =>
            (if Which = Running_TCB (S'Old)
             then Queue_Of (S, Which) = Free
             else Is_Unchanged (S'Old, S, Which)))
       and then Order_Is_Kept (S'Old, S, Except => Running_TCB (S'Old))
       and then
         (for all Other in TCB_Number =>
            (if Other /= Running_TCB (S'Old)
               and then Queue_Of (S, Other) = Free
             then Is_Ahead (S, Other, Running_TCB (S'Old))));

private

   subtype TCB_Count is Integer range 0 .. Number_Of_TCBs;

   type Task_Control_Block is record
      Id          : Task_Id  := No_Task;
      Priority    : Task_Trees.Priority := 0;
      Release     : Tick     := 0;
      New_Release : Boolean  := False;
      First_Run   : Boolean  := False;
   end record;

   type TCB_Table is array (TCB_Number) of Task_Control_Block;

   --  The row of TCBs holds the running task, if any, then the ready queue,
   --  then the timer queue, then the free TCBs.
   type Scheduler is record
      Row       : Arrangement := Initial_Arrangement;
      Busy      : Boolean     := False;
      Ready     : TCB_Count   := 0;
      Sleeping  : TCB_Count   := 0;
      Blocks    : TCB_Table   := (others => <>);
      Now       : Clock_Tick  := 0;
      Late      : Count       := 0;
   end record;

   --  Where the queues end in the row.

   function Running_Last (S : Scheduler) return Integer is
     (if S.Busy then 1 else 0);

   function Ready_Last (S : Scheduler) return Integer is
     (Running_Last (S) + S.Ready);

   function Timer_Last (S : Scheduler) return Integer is
     (Ready_Last (S) + S.Sleeping);

   function Place_Number (S : Scheduler; Which : TCB_Number) return Integer is
     (Integer (Place_Of (S.Row, Which)));

   function Queue_Of (S : Scheduler; Which : TCB_Number) return Queue_Name is
     (declare
         Where : constant Integer := Place_Number (S, Which);
      begin
         (if Where <= Running_Last (S) then Running
          elsif Where <= Ready_Last (S) then Ready
          elsif Where <= Timer_Last (S) then Timer
          else Free));

   function Is_Ahead
     (S            : Scheduler;
      First, Other : TCB_Number) return Boolean
   is
     (Place_Of (S.Row, First) < Place_Of (S.Row, Other));

   function Id_Of (S : Scheduler; Which : TCB_Number) return Task_Id is
     (S.Blocks (Which).Id);

   function Priority_Of
     (S : Scheduler; Which : TCB_Number) return Priority
   is
     (S.Blocks (Which).Priority);

   function Release_Of (S : Scheduler; Which : TCB_Number) return Tick is
     (S.Blocks (Which).Release);

   function Is_New_Release
     (S : Scheduler; Which : TCB_Number) return Boolean
   is
     (S.Blocks (Which).New_Release);

   function Is_First_Run
     (S : Scheduler; Which : TCB_Number) return Boolean
   is
     (S.Blocks (Which).First_Run);

   function Clock (S : Scheduler) return Clock_Tick is (S.Now);

   function Overruns (S : Scheduler) return Count is (S.Late);

   function Is_Idle (S : Scheduler) return Boolean is (not S.Busy);

   function Next_Free_TCB (S : Scheduler) return TCB_Number is
     (TCB_At (S.Row, Place (Timer_Last (S) + 1)));

   --  The ready queue is in the order of priorities.
   function Ready_In_Order (S : Scheduler) return Boolean is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           (if Queue_Of (S, A) = Ready and then Queue_Of (S, B) = Ready
              and then Is_Ahead (S, A, B)
            then Priority_Of (S, A) >= Priority_Of (S, B))));

   --  The timer queue is in the order of ticks, all of them to come.
   function Timer_In_Order (S : Scheduler) return Boolean is
     (for all A in TCB_Number =>
        (for all B in TCB_Number =>
           (if Queue_Of (S, A) = Timer and then Queue_Of (S, B) = Timer
              and then Is_Ahead (S, A, B)
            then Release_Of (S, A) <= Release_Of (S, B))));

   function Sleepers_Are_Not_Due (S : Scheduler) return Boolean is
     (for all Which in TCB_Number =>
        (if Queue_Of (S, Which) = Timer
         then Release_Of (S, Which) > Clock (S)));

   function Queues_Fit (S : Scheduler) return Boolean is
     (Is_Sound (S.Row) and then Timer_Last (S) <= Number_Of_TCBs);

   function Is_Sound (S : Scheduler) return Boolean is
     (Queues_Fit (S)
      and then Ready_In_Order (S)
      and then Timer_In_Order (S)
      and then Sleepers_Are_Not_Due (S));

   function Running_TCB (S : Scheduler) return TCB_Number is
     (TCB_At (S.Row, 1));

   function Empty_Scheduler (Now : Clock_Tick) return Scheduler is
     ((Now => Now, others => <>));

   --  The head of the timer queue, if there is one, is due.
   function Sleeper_Is_Due
     (S   : Scheduler;
      Now : Clock_Tick) return Boolean
   is
     (S.Sleeping > 0
      and then
        Release_Of (S, TCB_At (S.Row, Place (Ready_Last (S) + 1))) <= Now)
   with
     Global => null,
     Pre    => Queues_Fit (S);

end URVOS.Schedulers;
