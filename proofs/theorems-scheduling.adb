--  SPDX-License-Identifier: Apache-2.0

with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;

package body Theorems.Scheduling with SPARK_Mode is

   --  What holds from a first state to a middle one, and from there to a
   --  last one, holds from the first to the last.

   procedure Prove_Kept (First, Middle, Last : Scheduler)
   with
     Global => null,
     Pre    => All_Are_Kept (First, Middle)
       and then All_Are_Kept (Middle, Last),
     Post   => All_Are_Kept (First, Last);

   procedure Prove_Nobody_Is_Woken_Early (First, Middle, Last : Scheduler)
   with
     Global => null,
     Pre    =>
       Clock (First) <= Clock (Middle)
       and then Clock (Middle) <= Clock (Last)
       and then Nobody_Is_Woken_Early (First, Middle)
       and then Nobody_Is_Woken_Early (Middle, Last),
     Post   => Nobody_Is_Woken_Early (First, Last);

   procedure Prove_Kept (First, Middle, Last : Scheduler) is null;

   procedure Prove_Nobody_Is_Woken_Early
     (First, Middle, Last : Scheduler) is null;

   --  Who sleeps is not due.
   procedure Prove_None_Is_Due (S : Scheduler)
   with
     Global => null,
     Pre    => Is_Sound (S),
     Post   =>
       (for all Which in TCB_Number =>
          (if Queue_Of (S, Which) = Timer
           then Release_Of (S, Which) > Clock (S)));

   procedure Prove_None_Is_Due (S : Scheduler) is null;

   procedure Step (S : in out Scheduler; Call : Scheduler_Call) is
      Before : constant Scheduler := S;
   begin
      if not Is_Allowed (S, Call) then
         return;
      end if;

      case Call.Kind is
         when Loads =>
            Load (S, Call.Header);
            pragma Assert
              (Others_Are_Kept (Before, S, Except => Next_Free_TCB (Before)));
            pragma Assert (Nobody_Is_Woken_Early (Before, S));

         when Dispatches =>
            Dispatch (S);
            pragma Assert (All_Are_Kept (Before, S));
            pragma Assert (Nobody_Is_Woken_Early (Before, S));

         when Wakes =>
            Wake (S, Call.Now);
            pragma Assert (All_Are_Kept (Before, S));
            pragma Assert (Nobody_Is_Woken_Early (Before, S));

         when Exits =>
            Exit_Call (S);
            pragma Assert (All_Are_Kept (Before, S));
            pragma Assert (Nobody_Is_Woken_Early (Before, S));

         when Sleeps =>
            Sleep (S, Call.Until_Tick);
            pragma Assert (All_Are_Kept (Before, S));
            pragma Assert (Nobody_Is_Woken_Early (Before, S));

         when Terminates =>
            Terminate_Caller (S);
            pragma Assert
              (Others_Are_Kept (Before, S, Except => Running_TCB (Before)));
            pragma Assert (Nobody_Is_Woken_Early (Before, S));
      end case;
   end Step;

   procedure Dispatch_Chooses_The_Best (S : in out Scheduler) is
   begin
      Dispatch (S);
   end Dispatch_Chooses_The_Best;

   procedure Exit_Chooses_The_Best (S : in out Scheduler) is
      Before : constant Scheduler := S;
      Caller : constant TCB_Number := Running_TCB (S);
   begin
      Exit_Call (S);
      if Has_Higher_Ready (Before) then
         pragma Assert
           (Priority_Of (S, Running_TCB (S)) > Priority_Of (S, Caller));
         pragma Assert
           (for all Which in TCB_Number =>
              (if Queue_Of (S, Which) = Ready and then Which /= Caller
               then Queue_Of (Before, Which) = Ready));
      else
         pragma Assert (S = Before);
         pragma Assert (Best_Runs (Before));
      end if;
   end Exit_Chooses_The_Best;

   procedure Run (S : in out Scheduler; Calls : Call_Sequence) is
      Before : constant Scheduler := S;
      Last   : Scheduler;
   begin
      for I in Calls'Range loop
         pragma Loop_Invariant (Is_Sound (S));
         pragma Loop_Invariant (Clock (S) >= Clock (Before));
         pragma Loop_Invariant
           (if (for all J in Calls'First .. I - 1 =>
                  Calls (J).Kind not in Loads | Terminates)
            then All_Are_Kept (Before, S));
         pragma Loop_Invariant (Nobody_Is_Woken_Early (Before, S));

         Last := S;
         Step (S, Calls (I));
         if (for all J in Calls'First .. I =>
               Calls (J).Kind not in Loads | Terminates)
         then
            Prove_Kept (Before, Last, S);
         end if;
         Prove_Nobody_Is_Woken_Early (Before, Last, S);
      end loop;
      Prove_None_Is_Due (S);
   end Run;

end Theorems.Scheduling;
