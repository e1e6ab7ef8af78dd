--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Schedulers.Calls with SPARK_Mode is

   --  The ready queue has one head.
   procedure Prove_One_Head (S : Scheduler; One, Other : TCB_Count)
   with
     Ghost,
     Global => null,
     Pre    => Is_Head (S, Ready, One) and then Is_Head (S, Ready, Other),
     Post   => One = Other;

   --  The one of two TCBs that is ahead. It is out of the loop, which is short
   --  and runs often.
   function Better (S : Scheduler; Head, Which : TCB_Number) return TCB_Number
   is
     (if Is_Ahead (S, Which, Head) then Which else Head)
   with
     No_Inline,
     Global => null;

   --  Head_Of for the ready queue, from the TCBs that may be in it.
   --  Others_Wait: another TCB is ready, too.
   procedure Find_Ready
     (S           : Scheduler;
      TCBs        : TCB_Range;
      Head        : out TCB_Count;
      Others_Wait : out Boolean)
   with
     Global => null,
     Pre    => Ready_Are_In (S, TCBs),
     Post   =>
       Head = Head_Of (S, Ready)
       and then
         (if not Others_Wait
          then (for all Which in TCB_Number =>
                  (if Queue_Of (S, Which) = Ready then Which = Head)));

   --  Moves one TCB to the end.
   procedure Move_To_End (Turns : in out Turn_Numbers; Which : TCB_Number)
   with
     Inline,
     Pre  => Are_Turns (Turns),
     Post => Turns = With_Last (Turns'Old, Which);

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

   procedure Prove_One_Head (S : Scheduler; One, Other : TCB_Count) is
   begin
      if One /= No_TCB and then Other /= No_TCB and then One /= Other then
         pragma Assert (Is_Ahead (S, One, Other));
         pragma Assert (not Is_Ahead (S, Other, One));
      end if;
   end Prove_One_Head;

   procedure Find_Ready
     (S           : Scheduler;
      TCBs        : TCB_Range;
      Head        : out TCB_Count;
      Others_Wait : out Boolean)
   is
      Now : constant Clock_Tick := S.Clock;
   begin
      Head := No_TCB;
      Others_Wait := False;
      for Which in TCBs.First .. TCBs.Last loop
         pragma Assert
           (for all Other in TCB_Number =>
              (if Other /= Which
               then Is_Ahead (S, Other, Which) /= Is_Ahead (S, Which, Other)));
         if S.TCBs (Which).Id /= No_Task
           and then S.TCBs (Which).Ready_At <= Now
           and then Which /= S.Running
         then
            if Head = No_TCB then
               Head := Which;
            else
               Others_Wait := True;
               if S.TCBs (Which).Priority >= S.TCBs (Head).Priority then
                  Head := Better (S, Head, Which);
               end if;
            end if;
         end if;
         pragma Loop_Invariant (Is_Head (S, Ready, Head, Which));
         pragma Loop_Invariant
           (if not Others_Wait
            then (for all Place in 1 .. Which =>
                    (if Queue_Of (S, Place) = Ready then Place = Head)));
      end loop;
      Prove_One_Head (S, Head, Head_Of (S, Ready));
   end Find_Ready;

   procedure Move_To_End (Turns : in out Turn_Numbers; Which : TCB_Number) is
      Mine   : constant Turn         := Turns (Which);
      Before : constant Turn_Numbers := Turns with Ghost;
   begin
      for Each in TCB_Number loop
         if Turns (Each) > Mine then
            Turns (Each) := Turns (Each) - 1;
         end if;
         pragma Loop_Invariant
           (for all Place in TCB_Number =>
              (if Place <= Each and then Place /= Which
               then Turns (Place) = With_Last (Before, Which) (Place)
               else Turns (Place) = Before (Place)));
      end loop;
      Turns (Which) := Last_Turn;
   end Move_To_End;

   procedure Queue
     (S     : in out Scheduler;
      Which : TCB_Number;
      Value : Task_Control_Block) is
   begin
      if S.Running = Which then
         S.Running := No_TCB;
      end if;
      S.TCBs (Which) := Value;
      Move_To_End (S.Turns, Which);
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

   procedure Dispatch (S : in out Scheduler; May_Be_Ready : in out TCB_Range)
   is
      Best        : TCB_Count;
      Others_Wait : Boolean;
   begin
      if S.Running = No_TCB then
         Find_Ready (S, May_Be_Ready, Best, Others_Wait);
         if Best /= No_TCB then
            Switch_To (S, Best);
         end if;
         if not Others_Wait then
            May_Be_Ready := No_TCBs;
         end if;
      end if;
   end Dispatch;

   procedure Dispatch (S : in out Scheduler) is
      Unused_May_Be_Ready : TCB_Range := All_TCBs;
   begin
      Dispatch (S, Unused_May_Be_Ready);
   end Dispatch;

   procedure Wake (S : in out Scheduler; Now : Clock_Tick) is
   begin
      S.Clock := Now;
   end Wake;

   procedure Exit_Call (S : in out Scheduler) is
      Best               : TCB_Count;
      Unused_Others_Wait : Boolean;
   begin
      Find_Ready (S, All_TCBs, Best, Unused_Others_Wait);
      if Best /= No_TCB
        and then S.TCBs (Best).Priority > S.TCBs (S.Running).Priority
      then
         Queue
           (S, S.Running, (S.TCBs (S.Running) with delta Ready_At => S.Clock));
         Switch_To (S, Best);
      end if;
   end Exit_Call;

   procedure Sleep (S : in out Scheduler; Until_Tick : Tick) is
      Caller  : constant TCB_Number := S.Running;
      Release : constant Tick       := Tick'Max (Until_Tick, S.Clock + 1);
      Before  : constant Scheduler  := S with Ghost;
   begin
      if S.Clock - S.TCBs (Caller).Release >= Ticks_Per_Major_Frame then
         S.Overruns := Incremented (S.Overruns);
      end if;
      S.Running := No_TCB;
      S.TCBs (Caller).Release := Release;
      S.TCBs (Caller).Ready_At := Release;
      S.TCBs (Caller).New_Release := True;
      S.TCBs (Caller).First_Run := False;
      Move_To_End (S.Turns, Caller);
      pragma Assert (Queue_Of (S, Caller) = Timer);
      pragma Assert
        (for all Which in TCB_Number =>
           (if Which /= Caller
            then Queue_Of (S, Which) = Queue_Of (Before, Which)));
   end Sleep;

   procedure Terminate_Caller (S : in out Scheduler) is
   begin
      Queue (S, S.Running, Free_TCB);
   end Terminate_Caller;

end URVOS.Schedulers.Calls;
