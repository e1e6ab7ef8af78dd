--  SPDX-License-Identifier: Apache-2.0

--  What the scheduler does over any sequence of calls, with any tasks
--  (report, sections 3.2 and 3.3; KRN-1 to KRN-4).
--
--  A TCB is in exactly one queue at any time: Queue_Of has one answer.

with URVOS.Arrangements; use URVOS.Arrangements;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Schedulers;   use URVOS.Schedulers;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

package Theorems.Scheduling with Pure, SPARK_Mode, Ghost is

   type Call_Kind is (Loads, Dispatches, Wakes, Exits, Sleeps, Terminates);

   --  A call of the scheduler, with what it is given.
   type Scheduler_Call is record
      Kind       : Call_Kind;
      Header     : Task_Header;  --  that is loaded
      Now        : Clock_Tick;   --  at which the scheduler wakes
      Until_Tick : Tick;         --  that the caller sleeps
   end record;

   type Call_Sequence is array (Positive range <>) of Scheduler_Call;

   --  What its precondition asks for. Calls that are not allowed are never
   --  made; in a sequence they do nothing.
   function Is_Allowed
     (S    : Scheduler;
      Call : Scheduler_Call) return Boolean
   is
     (case Call.Kind is
         when Loads                       => Has_Free_TCB (S),
         when Dispatches                  => True,
         when Wakes                       => Call.Now >= Clock (S),
         when Exits | Sleeps | Terminates => not Is_Idle (S))
   with Global => null;

   --  The tasks are the same as before, each in its own TCB, but for one TCB.
   function Others_Are_Kept
     (Before, After : Scheduler;
      Except        : TCB_Number) return Boolean
   is
     (for all Which in TCB_Number =>
        (if Which /= Except
         then (Queue_Of (After, Which) = Free) =
                (Queue_Of (Before, Which) = Free)
           and then Id_Of (After, Which) = Id_Of (Before, Which)
           and then Priority_Of (After, Which) = Priority_Of (Before, Which)))
   with Global => null;

   --  The tasks are the same as before, each in its own TCB.
   function All_Are_Kept (Before, After : Scheduler) return Boolean is
     (for all Which in TCB_Number =>
        (Queue_Of (After, Which) = Free) = (Queue_Of (Before, Which) = Free)
        and then Id_Of (After, Which) = Id_Of (Before, Which)
        and then Priority_Of (After, Which) = Priority_Of (Before, Which))
   with Global => null;

   --  Who slept sleeps on if its tick has not come.
   function Nobody_Is_Woken_Early (Before, After : Scheduler) return Boolean is
     (for all Which in TCB_Number =>
        (if Queue_Of (Before, Which) = Timer
           and then Clock (After) < Release_Of (Before, Which)
         then Queue_Of (After, Which) = Timer
           and then Release_Of (After, Which) = Release_Of (Before, Which)))
   with Global => null;

   --  One call. No task is lost or duplicated: only LOAD takes a TCB, the
   --  first of the free ones, only TERMINATE gives one back, the caller's,
   --  and every other task stays in its own. Nobody is woken early.
   procedure Step (S : in out Scheduler; Call : Scheduler_Call)
   with
     Global => null,
     Pre    => Is_Sound (S),
     Post   =>
       Is_Sound (S)
       and then Clock (S) >= Clock (S'Old)
       and then Nobody_Is_Woken_Early (S'Old, S)
       and then
         (if Is_Allowed (S'Old, Call) and then Call.Kind = Loads
          then Others_Are_Kept (S'Old, S, Except => Next_Free_TCB (S'Old))
            and then Queue_Of (S, Next_Free_TCB (S'Old)) /= Free
            and then Id_Of (S, Next_Free_TCB (S'Old)) = Call.Header.Id
          elsif Is_Allowed (S'Old, Call) and then Call.Kind = Terminates
          then Others_Are_Kept (S'Old, S, Except => Running_TCB (S'Old))
            and then Queue_Of (S, Running_TCB (S'Old)) = Free
          else All_Are_Kept (S'Old, S));

   --  No ready task has a higher priority than the one that runs.
   function Best_Runs (S : Scheduler) return Boolean is
     (for all Which in TCB_Number =>
        (if Queue_Of (S, Which) = Ready
         then Priority_Of (S, Which) <= Priority_Of (S, Running_TCB (S))))
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Is_Idle (S);

   --  An idle processor is given to a task of the highest priority, and
   --  stays idle only if no task is ready.
   procedure Dispatch_Chooses_The_Best (S : in out Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S) and then Is_Idle (S),
     Post   =>
       Is_Sound (S)
       and then
         (if Is_Idle (S)
          then (for all Which in TCB_Number => Queue_Of (S, Which) /= Ready)
          else Best_Runs (S));

   --  So it is after EXIT, whether another task runs then or the caller.
   procedure Exit_Chooses_The_Best (S : in out Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S) and then not Is_Idle (S),
     Post   =>
       Is_Sound (S)
       and then not Is_Idle (S)
       and then Best_Runs (S);

   --  Any sequence of calls. Without LOAD and TERMINATE the tasks remain the
   --  same. A sleeper is in the timer queue until its tick, and not longer.
   procedure Run (S : in out Scheduler; Calls : Call_Sequence)
   with
     Global => null,
     Pre    => Is_Sound (S),
     Post   =>
       Is_Sound (S)
       and then Clock (S) >= Clock (S'Old)
       and then
         (if (for all Call of Calls => Call.Kind not in Loads | Terminates)
          then All_Are_Kept (S'Old, S))
       and then Nobody_Is_Woken_Early (S'Old, S)
       and then
         (for all Which in TCB_Number =>
            (if Queue_Of (S, Which) = Timer
             then Release_Of (S, Which) > Clock (S)));

end Theorems.Scheduling;
