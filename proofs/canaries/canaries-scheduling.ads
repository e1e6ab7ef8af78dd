--  SPDX-License-Identifier: Apache-2.0

--  Claims about the scheduler that exceed the truth by one step.

with Theorems.Scheduling; use Theorems.Scheduling;
with URVOS;               use URVOS;
with URVOS.Frames;        use URVOS.Frames;
with URVOS.Schedulers;    use URVOS.Schedulers;
with URVOS.Task_Trees;    use URVOS.Task_Trees;

package Canaries.Scheduling with Pure, SPARK_Mode, Ghost is

   --  False: a clock that moves on may wake a task.
   procedure No_Task_Is_Woken (S : Scheduler; Now : Clock_Tick)
   with
     Global => null,
     Pre    => Now >= Clock (S),
     Post   =>
       (for all Which in TCB_Number =>
          (if Queue_Of (S, Which) = Timer
           then Queue_Of  --  VC_POSTCONDITION
             (After_Wake (S, Now), Which) = Timer));

   --  False: EXIT may give the processor to another task.
   procedure The_Caller_Runs_On (S : Scheduler)
   with
     Global => null,
     Pre    => not Is_Idle (S),
     Post   =>
       Running_TCB (After_Exit (S)) = Running_TCB (S);  --  VC_POSTCONDITION

   --  False: TERMINATE removes the caller.
   procedure The_Caller_Is_Kept (S : Scheduler)
   with
     Global => null,
     Pre    => not Is_Idle (S),
     Post   => Are_Kept (S, After_Terminate (S));  --  VC_POSTCONDITION

   --  False: a task that starts to run may be late.
   procedure No_Task_Is_Late (S : Scheduler)
   with
     Global => null,
     Post   =>
       Overruns (After_Dispatch (S)) = Overruns (S);  --  VC_POSTCONDITION

end Canaries.Scheduling;
