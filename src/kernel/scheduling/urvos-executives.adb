--  SPDX-License-Identifier: Apache-2.0

with URVOS.Schedulers;       use URVOS.Schedulers;
with URVOS.Schedulers.Calls; use URVOS.Schedulers.Calls;

package body URVOS.Executives
  with
    SPARK_Mode,
    Refined_State => (Task_Management => (Present, Late))
is

   --  Others_Wait: a task besides the running one may be ready. While none is,
   --  the processor is idle when that one sleeps: the scheduler need not
   --  search.
   type Management is record
      Tasks       : Scheduler;
      Others_Wait : Boolean := True;
   end record
   with Predicate => Others_Wait or else Is_Alone (Tasks);

   Present : Management;
   Late    : Count := 0;

   Tasks : Scheduler renames Present.Tasks;

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
      Before      : constant Count := Overruns (Tasks);
      Others_Wait : Boolean;
   begin
      Present.Others_Wait := True;
      Dispatch (Tasks, Others_Wait);
      if not Others_Wait then
         Present.Others_Wait := False;
      end if;
      if not Is_Idle (Tasks) then
         Note_Overrun (Before, TCB (Tasks, Running_TCB (Tasks)).Id);
      end if;
   end Choose;

   procedure Start (Tree : Task_Tree; Now : Clock_Tick) is
   begin
      Present.Others_Wait := True;
      Start (Tasks, Tree, Now);
   end Start;

   procedure Clock_Interrupt (Now : Clock_Tick) is
   begin
      if Now >= Clock (Tasks) then
         Present.Others_Wait := True;
         Wake (Tasks, Now);
      end if;
      Choose;
   end Clock_Interrupt;

   function Time return Clock_Tick is (Clock (Tasks))
   with Refined_Global => Present;

   function Is_Idle return Boolean is (Is_Idle (Tasks))
   with Refined_Global => Present;

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
         Others_Wait : constant Boolean := Present.Others_Wait;
      begin
         Present.Others_Wait := True;
         Sleep (Tasks, Until_Tick);
         Note_Overrun (Before, Id);
         if Others_Wait then
            Choose;
         else
            Present.Others_Wait := False;
         end if;
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
         Present.Others_Wait := True;
         Wake (Tasks, Now);
      end if;

      case Call.Name is
         when Kernel_Calls.Exit_Call =>
            Present.Others_Wait := True;
            Schedulers.Calls.Exit_Call (Tasks);
            Note_Overrun (Before, TCB (Tasks, Running_TCB (Tasks)).Id);
            Runs_On := Running_TCB (Tasks) = Caller;

         when Sleep_Call =>
            Put_To_Sleep (Call.Until_Tick);

         when Next_Frame_Call =>
            Put_To_Sleep (Next_Release (Clock (Tasks), Call.Offset));

         when Terminate_Call =>
            Present.Others_Wait := True;
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
