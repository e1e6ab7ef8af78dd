--  SPDX-License-Identifier: Apache-2.0

with Ada.Synchronous_Task_Control; use Ada.Synchronous_Task_Control;
with System;
with URVOS.Executives;
with URVOS.Frame_Clocks; use URVOS.Frame_Clocks;
with URVOS.Frames;       use URVOS.Frames;
with URVOS.Task_Trees;   use URVOS.Task_Trees;

package body URVOS.Real_Time_Processors
  with
    SPARK_Mode,
    Refined_State =>
      (Power           => (Switch, Processor),
       Task_Management => (Executive.Task_Management, Now, Next_Tick))
is

   Tick_Time : constant Time_Span := Microseconds (Microseconds_Per_Tick);

   --  The delay before a task that called EXIT and runs on looks again.
   Look_Time : constant Time_Span := Microseconds (50);

   --  The power switch opens it.
   Switch : Suspension_Object;

   --  The processor's clock, and the time of its next tick.
   Now       : Clock_Tick := 0;
   Next_Tick : Time       := Time_First;

   --  Checks whether the clock has ticked. Observed is False after a
   --  self-test, which takes longer than a tick; the master's lateness is then
   --  not reported.
   procedure Follow_Clock (Observed : Boolean);

   procedure Read_Clock
     (Present : in out Clock_Tick; Has_Moved : in out Boolean);

   package Executive is
     new URVOS.Executives (Software.Step, Software.Report_Overrun, Read_Clock);

   --  The priority is the ceiling of the shared objects, so calls to them
   --  change no priorities.
   task Processor with Priority => System.Priority'Last;

   --  Carries out the order for this tick.
   procedure Follow_Orders (Next_Order : out Order);

   --  Runs steps until the clock ticks, no task is due, or a start is
   --  requested.
   procedure Run_Steps;

   procedure Follow_Clock (Observed : Boolean) is
      Present : constant Time := Clock;
      Request : Frame_Request;
   begin
      if Present >= Next_Tick then
         if Observed and then Self = Master then
            Observe_Tick (Present - Next_Tick);
         end if;
         Software.Look_At_Frame ((if Self = Master then 1 else 0), Request);
         This_Node.Follow (Present, Request, Now, Next_Tick);
         Software.Set_Time (Now);
      end if;
   end Follow_Clock;

   procedure Read_Clock
     (Present : in out Clock_Tick; Has_Moved : in out Boolean) is
   begin
      Follow_Clock (Observed => True);
      if Now > Present then
         Present := Now;
         Has_Moved := True;
      end if;
   end Read_Clock;

   procedure Follow_Orders (Next_Order : out Order) is
      Processors : constant Processor_Number := This_Node.Processors;
      Schedule   : constant Schedule_Name    := This_Node.Schedule;
      Passed     : Boolean;
   begin
      This_Node.Look (Self, Next_Order);
      case Next_Order.Name is
         when Carry_On =>
            Executive.Clock_Interrupt (Now);

         when Stand_Still =>
            null;

         when Begin_Start =>
            Software.Begin_Again (Next_Order.Condition, Now, Passed);
            This_Node.Note_Tested (Passed, Numbers_For (Next_Order.Present));

         when Load_Tasks =>
            Executive.Start
              ((if Next_Order.Passed
                then Software.Tasks.Tree_Of
                  (Processors, Next_Order.Number, Now, Schedule)
                else Empty_Tree),
               Now);
      end case;
   end Follow_Orders;

   procedure Run_Steps is
      Begun_At        : constant Clock_Tick := Now;
      Is_Start_Wanted : Boolean;
      Runs_On         : Boolean;
      Present         : Time;
   begin
      loop
         Is_Start_Wanted := This_Node.Is_Start_Wanted;
         exit when Is_Start_Wanted
           or else Now /= Begun_At
           or else Executive.Is_Idle;
         Executive.Run_Step (Runs_On);
         if Runs_On then
            Present := Clock;
            delay until Present + Look_Time;
         end if;
      end loop;
   end Run_Steps;

   task body Processor is
      Next_Order : Order;
      Begun_At   : Clock_Tick;
   begin
      Suspend_Until_True (Switch);
      Next_Tick := This_Node.Switched_On_At;
      Next_Tick := Next_Tick + Tick_Time;
      Software.Set_Time (Now);
      loop
         Begun_At := Now;
         Follow_Orders (Next_Order);
         if Next_Order.Name in Carry_On | Load_Tasks then
            Run_Steps;
         end if;
         This_Node.Note_Tick (Self, Now, Executive.Overruns);

         if Now = Begun_At then
            delay until Next_Tick;
            Follow_Clock (Observed => Next_Order.Name /= Begin_Start);
         end if;
      end loop;
   end Processor;

   procedure Switch_On is
   begin
      Set_True (Switch);
   end Switch_On;

end URVOS.Real_Time_Processors;
