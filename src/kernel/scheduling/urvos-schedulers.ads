--  SPDX-License-Identifier: Apache-2.0

--  The choice of the running task (report, sections 3.2 and 3.3; KRN-1 to
--  KRN-4, FRM-4).
--
--  A scheduler is the task management of one processor: task control blocks
--  (TCBs), the clock, and the running task. It works for any task tree. There
--  is no preemption: the running task gives up the processor by EXIT, SLEEP or
--  TERMINATE.
--
--  The queues are not sorted. Each TCB holds the tick at which its task is
--  ready, and its turn among those of the tick. Only the clock wakes a task.
--
--  Each call is modelled here as a function from one scheduler to the next,
--  for contracts and theorems. URVOS.Schedulers.Calls does the same in place.

with URVOS.Frames;     use URVOS.Frames;
with URVOS.Task_Trees; use URVOS.Task_Trees;

package URVOS.Schedulers with Pure, SPARK_Mode is

   --  32 bytes, so that a processor finds one by a shift.
   type Task_Control_Block is record
      Release     : Tick     := 0;        --  the next, or the last
      Ready_At    : Tick     := 0;        --  later than now: it sleeps
      Id          : Task_Id  := No_Task;  --  No_Task: the TCB is free
      Priority    : Task_Trees.Priority := 0;
      New_Release : Boolean  := False;    --  not run since its release
      First_Run   : Boolean  := False;    --  its initialisation is due
   end record
   with
     Predicate =>
       Task_Control_Block.Id /= No_Task
       or else
         (Task_Control_Block.Priority = 0
          and then Task_Control_Block.Ready_At = 0);

   for Task_Control_Block use record
      Release     at  0 range 0 .. 63;  Ready_At  at  8 range 0 .. 63;
      Id          at 16 range 0 .. 31;  Priority  at 20 range 0 .. 31;
      New_Release at 24 range 0 .. 31;  First_Run at 28 range 0 .. 31;
   end record;

   Free_TCB : constant Task_Control_Block := (others => <>);

   --  At first all TCBs are free, and the clock is 0.
   type Scheduler is private;

   --  The state of a scheduler

   function TCB (S : Scheduler; Which : TCB_Number) return Task_Control_Block
   with Global => null;

   --  The latest time that the scheduler was given.
   function Clock (S : Scheduler) return Clock_Tick
   with Global => null;

   --  The number of tasks released late or still running at the next release.
   function Overruns (S : Scheduler) return Count
   with Global => null;

   --  The TCB of the running task, or No_TCB.
   function Running_TCB (S : Scheduler) return TCB_Count
   with
     Global => null,
     Post   =>
       (if Running_TCB'Result /= No_TCB
        then TCB (S, Running_TCB'Result).Id /= No_Task);

   function Is_Idle (S : Scheduler) return Boolean is
     (Running_TCB (S) = No_TCB)
   with Global => null;

   type Queue_Name is (Running, Ready, Timer, Free);

   --  The queue of a TCB. The queue Running has at most one TCB.
   function Queue_Of (S : Scheduler; Which : TCB_Number) return Queue_Name is
     (if Which = Running_TCB (S) then Running
      elsif TCB (S, Which).Id = No_Task then Free
      elsif TCB (S, Which).Ready_At <= Clock (S) then Ready
      else Timer)
   with Global => null;

   --  First was queued before Other. It decides between TCBs of one tick.
   function Came_First
     (S : Scheduler; First, Other : TCB_Number) return Boolean
   with Global => null;

   --  First is chosen before Other, both ready or both free: it has the higher
   --  priority, or came earlier.
   function Is_Ahead (S : Scheduler; First, Other : TCB_Number) return Boolean
   is
     (if TCB (S, First).Priority /= TCB (S, Other).Priority
      then TCB (S, First).Priority > TCB (S, Other).Priority
      elsif TCB (S, First).Ready_At /= TCB (S, Other).Ready_At
      then TCB (S, First).Ready_At < TCB (S, Other).Ready_At
      else Came_First (S, First, Other))
   with Global => null;

   --  Among the TCBs up to Last, Head is in the queue and ahead of all others
   --  in it; Head is No_TCB if the queue is empty.
   function Is_Head
     (S     : Scheduler;
      Queue : Queue_Name;
      Head  : TCB_Count;
      Last  : TCB_Number := TCB_Number'Last) return Boolean
   is
     ((if Head /= No_TCB
       then Head <= Last and then Queue_Of (S, Head) = Queue)
      and then
        (for all Other in 1 .. Last =>
           (if Queue_Of (S, Other) = Queue and then Other /= Head
            then Head /= No_TCB and then Is_Ahead (S, Head, Other))))
   with Ghost, Global => null;

   --  The next TCB of the ready or the free queue, or No_TCB.
   function Head_Of (S : Scheduler; Queue : Queue_Name) return TCB_Count
   with
     Global => null,
     Post   => Is_Head (S, Queue, Head_Of'Result);

   function Has_Free_TCB (S : Scheduler) return Boolean is
     (Head_Of (S, Free) /= No_TCB)
   with Global => null;

   --  A ready task has a higher priority than the running one.
   function Has_Higher_Ready (S : Scheduler) return Boolean is
     (declare
         Best : constant TCB_Count := Head_Of (S, Ready);
      begin
         Best /= No_TCB
         and then TCB (S, Best).Priority > TCB (S, Running_TCB (S)).Priority)
   with
     Global => null,
     Pre    => not Is_Idle (S);

   --  The running task has not ended although its next release, a major frame
   --  after the last one, has come.
   function Has_Overrun (S : Scheduler) return Boolean is
     (Clock (S) >= Ticks_Per_Major_Frame
      and then TCB (S, Running_TCB (S)).Release <=
                 Clock (S) - Ticks_Per_Major_Frame)
   with
     Global => null,
     Pre    => not Is_Idle (S);

   --  Starting

   --  The scheduler after the tasks of a tree are loaded: one TCB for each
   --  header, in order. No task runs yet.
   function Loaded_Tree (Tree : Task_Tree; Now : Clock_Tick) return Scheduler
   with Global => null;

   --  Gives the first free TCB to the task of a header.
   function After_Load (S : Scheduler; Header : Task_Header) return Scheduler
   with
     Ghost,
     Global => null,
     Pre    => Header.Id /= No_Task and then Has_Free_TCB (S);

   --  Gives an idle processor to the best ready task, if any. A task that gets
   --  it after the tick of its release has overrun.
   function After_Dispatch (S : Scheduler) return Scheduler
   with Ghost, Global => null;

   --  The clock

   --  The time is Now. Sleeping tasks whose tick has come are ready.
   function After_Wake (S : Scheduler; Now : Clock_Tick) return Scheduler
   with
     Ghost,
     Global => null,
     Pre    => Now >= Clock (S);

   --  The calls of the running task

   --  EXIT: the caller gives the processor to the best ready task if that has
   --  a higher priority. Otherwise the caller continues.
   function After_Exit (S : Scheduler) return Scheduler
   with
     Ghost,
     Global => null,
     Pre    => not Is_Idle (S);

   --  SLEEP until a tick, or until the next tick if that one has passed. The
   --  processor becomes idle; see Dispatch.
   function After_Sleep (S : Scheduler; Until_Tick : Tick) return Scheduler
   with
     Ghost,
     Global => null,
     Pre    => not Is_Idle (S);

   --  TERMINATE, or the end of a task's statements. The caller's TCB becomes
   --  the last free one. The processor becomes idle.
   function After_Terminate (S : Scheduler) return Scheduler
   with
     Ghost,
     Global => null,
     Pre    => not Is_Idle (S);

private

   --  The place of one queued TCB among all; a whole byte needs no checks.
   type Turn is range 0 .. 255 with Size => 8;
   Last_Turn : constant Turn := Number_Of_TCBs;

   type Turn_Numbers is array (TCB_Number) of Turn with Alignment => 2;

   function Are_Turns (Turns : Turn_Numbers) return Boolean is
     (for all A in TCB_Number => Turns (A) in 1 .. Last_Turn
      and then
        (for all B in TCB_Number => (if A /= B then Turns (A) /= Turns (B))));

   subtype Turn_Table is Turn_Numbers with Predicate => Are_Turns (Turn_Table);

   type TCB_Table is array (TCB_Number) of Task_Control_Block;

   type Scheduler is record
      TCBs     : TCB_Table  := (others => Free_TCB);
      Turns    : Turn_Table := (for Which in TCB_Number => Turn (Which));
      Running  : TCB_Count  := No_TCB;
      Clock    : Clock_Tick := 0;
      Overruns : Count      := 0;
   end record
   with
     Predicate =>
       Scheduler.Running = No_TCB
       or else Scheduler.TCBs (Scheduler.Running).Id /= No_Task;

   function TCB (S : Scheduler; Which : TCB_Number) return Task_Control_Block
   is (S.TCBs (Which));

   function Clock (S : Scheduler) return Clock_Tick is (S.Clock);

   function Overruns (S : Scheduler) return Count is (S.Overruns);

   function Running_TCB (S : Scheduler) return TCB_Count is (S.Running);

   function Came_First
     (S : Scheduler; First, Other : TCB_Number) return Boolean
   is (S.Turns (First) < S.Turns (Other));

   --  Moves one TCB to the end; those after it move up by one.
   function With_Last
     (Turns : Turn_Table; Which : TCB_Number) return Turn_Table
   is
     (for Each in TCB_Number =>
        (if Turns (Each) > Turns (Which) then Turns (Each) - 1
         elsif Each /= Which then Turns (Each)
         else Last_Turn));

   --  Gives a TCB a new value and the last turn. Running is the TCB of the
   --  running task afterwards.
   function Queued
     (S       : Scheduler;
      Which   : TCB_Number;
      Value   : Task_Control_Block;
      Running : TCB_Count := No_TCB) return Scheduler
   is
     ((S with delta
         TCBs    => (S.TCBs with delta Which => Value),
         Turns   => With_Last (S.Turns, Which),
         Running => Running))
   with
     Ghost,
     Pre =>
       Running = No_TCB
       or else (Running /= Which and then S.TCBs (Running).Id /= No_Task);

   --  A task that starts to run now has overrun: its release has passed.
   function Is_Late (S : Scheduler; Which : TCB_Number) return Boolean is
     (S.TCBs (Which).New_Release and then S.TCBs (Which).Release < S.Clock);

   --  Runs the task of a TCB.
   function Switched_To (S : Scheduler; Which : TCB_Number) return Scheduler is
     ((S with delta
         TCBs     => (S.TCBs with delta
                        Which =>
                          (S.TCBs (Which) with delta New_Release => False)),
         Running  => Which,
         Overruns => (if Is_Late (S, Which) then Incremented (S.Overruns)
                      else S.Overruns)))
   with Ghost, Pre => S.TCBs (Which).Id /= No_Task;

   --  The TCB of a newly loaded task.
   function Loaded
     (Header : Task_Header; Now : Clock_Tick) return Task_Control_Block
   is
     ((Release     => Header.Start_Time,
       Ready_At    => Tick'Max (Header.Start_Time, Now),
       Id          => Header.Id,
       Priority    => Header.Initial_Priority,
       New_Release => True,
       First_Run   => True))
   with Pre => Header.Id /= No_Task;

   --  The TCB of a sleeping task.
   function Slept
     (Item       : Task_Control_Block;
      Until_Tick : Tick;
      Now        : Clock_Tick) return Task_Control_Block
   is
     ((Item with delta
         Release | Ready_At => Tick'Max (Until_Tick, Now + 1),
         New_Release        => True,
         First_Run          => False))
   with Pre => Item.Id /= No_Task;

   function Loaded_Tree (Tree : Task_Tree; Now : Clock_Tick) return Scheduler
   is
     ((TCBs   =>
         (for Which in TCB_Number =>
            (if Is_In_Tree (Tree, Which) then Loaded (Tree (Which), Now)
             else Free_TCB)),
       Clock  => Now,
       others => <>));

   function After_Load (S : Scheduler; Header : Task_Header) return Scheduler
   is
     (Queued
        (S, Head_Of (S, Free), Loaded (Header, S.Clock),
         Running => S.Running));

   function After_Dispatch (S : Scheduler) return Scheduler is
     (if Is_Idle (S) and then Head_Of (S, Ready) /= No_TCB
      then Switched_To (S, Head_Of (S, Ready))
      else S);

   function After_Wake (S : Scheduler; Now : Clock_Tick) return Scheduler is
     ((S with delta Clock => Now));

   function After_Exit (S : Scheduler) return Scheduler is
     (if Has_Higher_Ready (S)
      then Switched_To
        (Queued
           (S, S.Running, (S.TCBs (S.Running) with delta Ready_At => S.Clock)),
         Head_Of (S, Ready))
      else S);

   function After_Sleep (S : Scheduler; Until_Tick : Tick) return Scheduler is
     ((Queued
         (S, S.Running, Slept (S.TCBs (S.Running), Until_Tick, S.Clock))
       with delta
         Overruns => (if Has_Overrun (S) then Incremented (S.Overruns)
                      else S.Overruns)));

   function After_Terminate (S : Scheduler) return Scheduler is
     (Queued (S, S.Running, Free_TCB));

end URVOS.Schedulers;
