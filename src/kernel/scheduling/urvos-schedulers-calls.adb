--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Schedulers.Calls with SPARK_Mode is

   --  Gives a TCB a new value and the last turn.
   procedure Queue
     (S     : in out Scheduler;
      Which : TCB_Number;
      Value : Task_Control_Block)
   with
     Pre  => Which = S.Running or else Value.Id /= No_Task,
     Post =>
       S = Queued
             (S'Old, Which, Value,
              Running => (if Which = S'Old.Running then No_TCB
                          else S'Old.Running));

   --  Runs the task of a TCB.
   procedure Switch_To (S : in out Scheduler; Which : TCB_Number)
   with
     Pre  => S.TCBs (Which).Id /= No_Task,
     Post => S = Switched_To (S'Old, Which);

   procedure Queue
     (S     : in out Scheduler;
      Which : TCB_Number;
      Value : Task_Control_Block) is
   begin
      if S.Running = Which then
         S.Running := No_TCB;
      end if;
      S.TCBs (Which) := Value;
      S.Turns := With_Last (S.Turns, Which);
   end Queue;

   procedure Switch_To (S : in out Scheduler; Which : TCB_Number) is
   begin
      if Is_Late (S, Which) then
         S.Overruns := Incremented (S.Overruns);
      end if;
      S.TCBs (Which).New_Release := False;
      S.Running := Which;
   end Switch_To;

   procedure Start (S : out Scheduler; Tree : Task_Tree; Now : Clock_Tick) is
   begin
      S := Loaded_Tree (Tree, Now);
      Dispatch (S);
   end Start;

   procedure Load (S : in out Scheduler; Header : Task_Header) is
   begin
      Queue (S, Head_Of (S, Free), Loaded (Header, S.Clock));
   end Load;

   procedure Dispatch (S : in out Scheduler) is
      Best : TCB_Count;
   begin
      if S.Running = No_TCB then
         Best := Head_Of (S, Ready);
         if Best /= No_TCB then
            Switch_To (S, Best);
         end if;
      end if;
   end Dispatch;

   procedure Wake (S : in out Scheduler; Now : Clock_Tick) is
   begin
      S.Clock := Now;
   end Wake;

   procedure Exit_Call (S : in out Scheduler) is
      Best : constant TCB_Count := Head_Of (S, Ready);
   begin
      if Best /= No_TCB
        and then S.TCBs (Best).Priority > S.TCBs (S.Running).Priority
      then
         Queue
           (S, S.Running, (S.TCBs (S.Running) with delta Ready_At => S.Clock));
         Switch_To (S, Best);
      end if;
   end Exit_Call;

   procedure Sleep (S : in out Scheduler; Until_Tick : Tick) is
   begin
      if Has_Overrun (S) then
         S.Overruns := Incremented (S.Overruns);
      end if;
      Queue (S, S.Running, Slept (S.TCBs (S.Running), Until_Tick, S.Clock));
   end Sleep;

   procedure Terminate_Caller (S : in out Scheduler) is
   begin
      Queue (S, S.Running, Free_TCB);
   end Terminate_Caller;

end URVOS.Schedulers.Calls;
