--  SPDX-License-Identifier: Apache-2.0

--  What a call of the scheduler does follows from its contract alone (EVI-7,
--  as Theorems.Results has it of all else): of two schedulers that cannot be
--  told apart it makes two that cannot be told apart.

with Theorems.Alike_Schedulers; use Theorems.Alike_Schedulers;
with URVOS;                     use URVOS;
with URVOS.Arrangements;        use URVOS.Arrangements;
with URVOS.Frames;              use URVOS.Frames;
with URVOS.Schedulers;          use URVOS.Schedulers;
with URVOS.Schedulers.Calls;    use URVOS.Schedulers.Calls;
with URVOS.Schedulers.Changes;  use URVOS.Schedulers.Changes;
with URVOS.Task_Trees;          use URVOS.Task_Trees;

package Theorems.Scheduler_Results with SPARK_Mode, Ghost is

   --  What is asked of two that are alike has the same answer.
   procedure Of_Questions (One, Other : Scheduler)
   with
     Global => null,
     Pre    =>
       Is_Sound (One)
       and then Is_Sound (Other)
       and then Are_Alike (One, Other),
     Post   =>
       Is_Settled (One) = Is_Settled (Other)
       and then Has_Free_TCB (One) = Has_Free_TCB (Other)
       and then
         (if Has_Free_TCB (One)
          then Next_Free_TCB (One) = Next_Free_TCB (Other))
       and then
         (if not Is_Idle (One)
          then Running_TCB (One) = Running_TCB (Other)
            and then Has_Higher_Ready (One) = Has_Higher_Ready (Other)
            and then Has_Overrun (One) = Has_Overrun (Other))
       and then
         (for all Which in TCB_Number =>
            Is_Best_Ready (One, Which) = Is_Best_Ready (Other, Which));

   procedure Of_Start
     (Tree       : Task_Tree;
      Now        : Clock_Tick;
      One, Other : out Scheduler)
   with
     Global => null,
     Post   => Are_Alike (One, Other);

   --  The same call makes of alike schedulers alike ones.

   procedure Of_Load
     (One, Other : in out Scheduler;
      Header     : Task_Header)
   with
     Global => null,
     Pre    =>
       Is_Sound (One)
       and then Is_Sound (Other)
       and then Are_Alike (One, Other)
       and then Has_Free_TCB (One),
     Post   => Are_Alike (One, Other);

   procedure Of_Dispatch (One, Other : in out Scheduler)
   with
     Global => null,
     Pre    =>
       Is_Sound (One)
       and then Is_Sound (Other)
       and then Are_Alike (One, Other),
     Post   => Are_Alike (One, Other);

   procedure Of_Wake (One, Other : in out Scheduler; Now : Clock_Tick)
   with
     Global => null,
     Pre    =>
       Is_Sound (One)
       and then Is_Sound (Other)
       and then Are_Alike (One, Other)
       and then Now >= Clock (One),
     Post   => Are_Alike (One, Other);

   procedure Of_Exit_Call (One, Other : in out Scheduler)
   with
     Global => null,
     Pre    =>
       Is_Sound (One)
       and then Is_Sound (Other)
       and then Are_Alike (One, Other)
       and then not Is_Idle (One),
     Post   => Are_Alike (One, Other);

   procedure Of_Sleep (One, Other : in out Scheduler; Until_Tick : Tick)
   with
     Global => null,
     Pre    =>
       Is_Sound (One)
       and then Is_Sound (Other)
       and then Are_Alike (One, Other)
       and then not Is_Idle (One),
     Post   => Are_Alike (One, Other);

   procedure Of_Terminate_Caller (One, Other : in out Scheduler)
   with
     Global => null,
     Pre    =>
       Is_Sound (One)
       and then Is_Sound (Other)
       and then Are_Alike (One, Other)
       and then not Is_Idle (One),
     Post   => Are_Alike (One, Other);

end Theorems.Scheduler_Results;
