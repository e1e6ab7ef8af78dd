--  SPDX-License-Identifier: Apache-2.0

with URVOS.Schedulers;       use URVOS.Schedulers;
with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;

package body URVOS.Executives
  with
    SPARK_Mode,
    Refined_State => (Task_Management => (Tasks, Late))
is

   Tasks : Scheduler;
   Late  : Count := 0;

   --  Between two ticks each task sleeps at most once, and before one of them
   --  sleeps it gives way at most once to each task of higher priority.
   Steps_Per_Tick : constant := Number_Of_TCBs * (Number_Of_TCBs + 1);

   --  Reports an overrun if the scheduler has counted one since Before.
   procedure Note_Overrun (Before : Count; Who : Task_Id);

   --  Gives an idle processor to the next task.
   procedure Choose
   with Post => Clock (Tasks) = Clock (Tasks)'Old;

   procedure Note_Overrun (Before : Count; Who : Task_Id) is
   begin
      if Overruns (Tasks) /= Before then
         Late := Incremented (Late);
         Report_Overrun (Who);
      end if;
   end Note_Overrun;

   procedure Choose is
      Before : constant Count := Overruns (Tasks);
   begin
      Dispatch (Tasks);
      if not Is_Idle (Tasks) then
         Note_Overrun (Before, TCB (Tasks, Running_TCB (Tasks)).Id);
      end if;
   end Choose;

   procedure Start (Tree : Task_Tree; Now : Clock_Tick) is
   begin
      Start (Tasks, Tree, Now);
   end Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      if Now >= Clock (Tasks) then
         Wake (Tasks, Now);
      end if;
      Choose;
   end Clock_Interrupt;

   function Time return Clock_Tick is (Clock (Tasks))
   with Refined_Global => Tasks;

   function Is_Idle return Boolean is (Is_Idle (Tasks))
   with Refined_Global => Tasks;

   procedure Run_Step (Runs_On : out Boolean) is
      Now    : Clock_Tick     := Clock (Tasks);
      Before : constant Count := Overruns (Tasks);
      Caller : TCB_Number;
      Id     : Task_Id;
      Call   : Kernel_Call;

      --  The caller sleeps until this tick.
      procedure Put_To_Sleep (Until_Tick : Tick)
      with
        Pre  => not Is_Idle (Tasks),
        Post => Clock (Tasks) = Clock (Tasks)'Old;

      procedure Put_To_Sleep (Until_Tick : Tick) is
      begin
         Sleep (Tasks, Until_Tick);
         Note_Overrun (Before, Id);
         Choose;
      end Put_To_Sleep;

   begin
      Runs_On := False;
      if Is_Idle (Tasks) then
         return;
      end if;

      Caller := Running_TCB (Tasks);
      Id := TCB (Tasks, Caller).Id;
      Step (Id, TCB (Tasks, Caller).First_Run, Now, Call);
      Read_Clock (Now);
      if Now > Clock (Tasks) then
         Wake (Tasks, Now);
      end if;

      case Call.Name is
         when Kernel_Calls.Exit_Call =>
            Schedulers.Calls.Exit_Call (Tasks);
            Note_Overrun (Before, TCB (Tasks, Running_TCB (Tasks)).Id);
            Runs_On := Running_TCB (Tasks) = Caller;

         when Sleep_Call =>
            Put_To_Sleep (Call.Until_Tick);

         when Next_Frame_Call =>
            Put_To_Sleep (Next_Release (Clock (Tasks), Call.Offset));

         when Terminate_Call =>
            Terminate_Caller (Tasks);
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
