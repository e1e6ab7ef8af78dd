--  SPDX-License-Identifier: Apache-2.0

with URVOS.Schedulers;       use URVOS.Schedulers;
with URVOS.Task_Managements; use URVOS.Task_Managements;

package body URVOS.Executives
  with
    SPARK_Mode,
    Refined_State => (Task_Management => (Present, Late))
is

   Present : Management;
   Late    : Count := 0;

   Tasks : Scheduler renames Present.Tasks;

   --  Between two ticks each task sleeps at most once, and before one of them
   --  sleeps it gives way at most once to each task of higher priority.
   Steps_Per_Tick : constant := Number_Of_TCBs * (Number_Of_TCBs + 1);

   --  Reports an overrun of a TCB's task if the scheduler has counted one
   --  since Before.
   procedure Note_Overrun (Before : Count; Which : TCB_Number);

   --  Gives an idle processor to the next task.
   procedure Choose
   with Inline, Post => Clock (Tasks) = Clock (Tasks)'Old;

   --  The same. It is out of line, for a tick at which no task is due.
   procedure Search
   with Post => Clock (Tasks) = Clock (Tasks)'Old;

   --  The running task, the caller, sleeps until a tick of the minor frame
   --  Released_In.
   procedure Put_To_Sleep
     (Caller      : TCB_Number;
      Until_Tick  : Tick;
      Released_In : Minor_Frame)
   with
     Inline,
     Pre  =>
       Caller = Running_TCB (Tasks)
       and then Released_In =
         Release_Frame (Tick'Max (Until_Tick, Clock (Tasks) + 1)),
     Post => Clock (Tasks) = Clock (Tasks)'Old;

   --  The running task, the caller, gives the processor to a ready task of
   --  higher priority, if any.
   procedure Give_Way (Caller : TCB_Number; Runs_On : out Boolean)
   with
     Pre  => Caller = Running_TCB (Tasks),
     Post => Clock (Tasks) = Clock (Tasks)'Old;

   procedure Note_Overrun (Before : Count; Which : TCB_Number) is
   begin
      if Overruns (Tasks) /= Before then
         Late := Incremented (Late);
         Report_Overrun (TCB (Tasks, Which).Id);
      end if;
   end Note_Overrun;

   procedure Search is
      Before : constant Count := Overruns (Tasks);
   begin
      Search (Present);
      if not Is_Idle (Tasks) then
         Note_Overrun (Before, Running_TCB (Tasks));
      end if;
   end Search;

   procedure Choose is
   begin
      if Has_Candidate (Present) then
         Search;
      end if;
   end Choose;

   procedure Put_To_Sleep
     (Caller      : TCB_Number;
      Until_Tick  : Tick;
      Released_In : Minor_Frame)
   is
      Before : constant Count := Overruns (Tasks);
   begin
      Put_To_Sleep (Present, Until_Tick, Released_In);
      Note_Overrun (Before, Caller);
      Choose;
   end Put_To_Sleep;

   procedure Give_Way (Caller : TCB_Number; Runs_On : out Boolean) is
      Before : constant Count := Overruns (Tasks);
   begin
      Give_Way (Present);
      Runs_On := Running_TCB (Tasks) = Caller;
      if not Runs_On then
         Note_Overrun (Before, Running_TCB (Tasks));
      end if;
   end Give_Way;

   procedure Start (Tree : Task_Tree; Now : Clock_Tick) is
   begin
      Start (Present, Tree, Now);
   end Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      Follow_Clock (Present, Now);
      Choose;
   end Clock_Interrupt;

   function Time return Clock_Tick is (Clock (Tasks))
   with Refined_Global => Present;

   function Is_Idle return Boolean is (Is_Idle (Tasks))
   with Refined_Global => Present;

   procedure Run_Step (Runs_On : out Boolean) is
      Now       : Clock_Tick := Clock (Tasks);
      Has_Moved : Boolean    := False;
      Caller    : TCB_Number;
      Call      : Kernel_Call;
   begin
      Runs_On := False;
      if Is_Idle (Tasks) then
         return;
      end if;

      Caller := Running_TCB (Tasks);
      Step
        (TCB (Tasks, Caller).Id, TCB (Tasks, Caller).First_Run, Now, Call);
      Read_Clock (Now, Has_Moved);
      if Has_Moved then
         Follow_Clock (Present, Now);
      end if;

      case Call.Name is
         when Kernel_Calls.Exit_Call =>
            Give_Way (Caller, Runs_On);

         when Sleep_Call =>
            Put_To_Sleep
              (Caller,
               Call.Until_Tick,
               Release_Frame (Tick'Max (Call.Until_Tick, Clock (Tasks) + 1)));

         when Next_Frame_Call =>
            Put_To_Sleep
              (Caller, Release_Of (Present, Call.Offset), Call.Offset);

         when Terminate_Call =>
            End_Task (Present);
            Choose;
      end case;
   end Run_Step;

   procedure Run_Until_Idle is
      Runs_On : Boolean;
   begin
      for Number in 1 .. Steps_Per_Tick loop
         exit when Is_Idle (Tasks);
         Run_Step (Runs_On);
         exit when Runs_On;
      end loop;
   end Run_Until_Idle;

   function Overruns return Count is (Late)
   with Refined_Global => Late;

end URVOS.Executives;
