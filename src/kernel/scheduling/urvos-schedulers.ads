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
--
--  What a scheduler is stands here; URVOS.Schedulers.Calls has what changes
--  it, URVOS.Schedulers.Changes the words for how.

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
