--  SPDX-License-Identifier: Apache-2.0

--  The calls of a scheduler (report, sections 3.2 and 3.3; KRN-1 to KRN-4,
--  FRM-4): those that start it, the clock's, and those of its running task.

with URVOS.Schedulers.Changes; use URVOS.Schedulers.Changes;

package URVOS.Schedulers.Calls with Pure, SPARK_Mode is

   --  Starting

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

end URVOS.Schedulers.Calls;
