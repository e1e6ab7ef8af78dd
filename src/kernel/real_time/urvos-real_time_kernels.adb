with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with System;

package body URVOS.Real_Time_Kernels
  with
    SPARK_Mode,
    Refined_State => (Power_Switch => (Power, Ticker))
is

   --  Opened by the power switch.
   Power : Suspension_Object;

   task Ticker with Priority => System.Default_Priority + 1;

   Tick_Time : constant Time_Span := Microseconds (Microseconds_Per_Tick);

   procedure Follow (Todo : Orders);

   procedure Follow (Todo : Orders) is
   begin
      if Todo.Late /= No_Task then
         Report_Overrun (Todo.Late);
      end if;
      if Todo.Next /= No_Task then
         if Todo.Late_Next then
            Report_Overrun (Todo.Next);
         end if;
         Resume (Todo.Next);
      end if;
   end Follow;

   task body Ticker is

      --  So many missed ticks are made up for at once.
      Most_Missed : constant := 100;

      Next_Tick : Time;
      Now       : Clock_Tick := 0;
      Woken_At  : Time;

      --  A self-test takes longer than a tick: the tasks are loaded at the
      --  tick that comes after it.
      Is_Starting : Boolean := False;
      Passed      : Boolean := False;

      Granted   : Wish;
      Todo      : Orders;
   begin
      Suspend_Until_True (Power);
      Next_Tick := Clock;
      loop
         Tell_Time (Now);
         if Is_Starting then
            Start_Tasks
              ((if Passed then Task_Tree_Of (Now) else Empty_Tree),
               Now,
               Todo);
            Is_Starting := False;
         else
            Wake (Now, Todo, Granted);
            if Granted.Is_There then
               Begin_Again (Granted.Condition, Now, Passed);
               Is_Starting := True;
            end if;
         end if;
         Follow (Todo);

         Next_Tick := Next_Tick + Tick_Time;
         delay until Next_Tick;
         Woken_At := Clock;
         if not Is_Starting then
            Observe_Tick (Woken_At - Next_Tick);
         end if;
         Now := Advanced (Now);
         for Missed in 1 .. Most_Missed loop
            exit when Next_Tick + Tick_Time > Woken_At;
            Next_Tick := Next_Tick + Tick_Time;
            Now := Advanced (Now);
         end loop;
      end loop;
   end Ticker;

   procedure Switch_On is
   begin
      Request_Start (Cold_Start);
      Set_True (Power);
   end Switch_On;

   procedure End_Step (Offset : Minor_Frame; Failed : Boolean) is
      Todo : Orders;
   begin
      End_Task_Step (Offset, Failed, Todo);
      Follow (Todo);
   end End_Step;

end URVOS.Real_Time_Kernels;
