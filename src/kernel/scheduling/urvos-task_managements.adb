--  SPDX-License-Identifier: Apache-2.0

package body URVOS.Task_Managements with SPARK_Mode is

   procedure Start
     (This : out Management; Tree : Task_Tree; Now : Clock_Tick)
   is
      Tasks : Scheduler;
   begin
      Start (Tasks, Tree, Now);
      This :=
        (Tasks        => Tasks,
         May_Be_Ready => All_TCBs,
         Released_In  =>
           (others =>
              (if (for some Which in TCB_Number =>
                     Queue_Of (Tasks, Which) = Timer)
               then All_TCBs
               else No_TCBs)),
         Place        => Unknown);
   end Start;

   procedure Follow_Clock (This : in out Management; Now : Clock_Tick) is
      Place : Frame_Place;
   begin
      if Now = Clock (This.Tasks) + 1 and then This.Place /= Unknown then
         Place :=
           (if This.Place = Frame_Place (Minor_Frame'Last) then 0
            else This.Place + 1);
         This.May_Be_Ready :=
           (if This.May_Be_Ready = No_TCBs
            then This.Released_In (Minor_Frame (Place))
            else Union
              (This.May_Be_Ready, This.Released_In (Minor_Frame (Place))));
      elsif Now > Clock (This.Tasks) then
         Place := Place_Of (Now);
         This.May_Be_Ready := All_TCBs;
      else
         return;
      end if;
      --  The place and the clock change together.
      This.Place := Unknown;
      Wake (This.Tasks, Now);
      if Place /= Unknown then
         This.Place := Place;
      end if;
   end Follow_Clock;

   procedure Search (This : in out Management) is
      May_Be_Ready : TCB_Range := This.May_Be_Ready;
   begin
      Dispatch (This.Tasks, May_Be_Ready);
      This.May_Be_Ready := May_Be_Ready;
   end Search;

   procedure Put_To_Sleep
     (This        : in out Management;
      Until_Tick  : Tick;
      Released_In : Minor_Frame)
   is
      Caller : constant TCB_Number := Running_TCB (This.Tasks);
   begin
      if not Is_In (Caller, This.Released_In (Released_In)) then
         This.Released_In (Released_In) :=
           Union (This.Released_In (Released_In), (Caller, Caller));
      end if;
      Sleep (This.Tasks, Until_Tick);
   end Put_To_Sleep;

   procedure Give_Way (This : in out Management) is
      Caller       : constant TCB_Number := Running_TCB (This.Tasks);
      May_Be_Ready : constant TCB_Range  := This.May_Be_Ready;
   begin
      This.May_Be_Ready := All_TCBs;
      Exit_Call (This.Tasks);
      if Running_TCB (This.Tasks) = Caller then
         This.May_Be_Ready := May_Be_Ready;
      end if;
   end Give_Way;

   procedure End_Task (This : in out Management) is
   begin
      Terminate_Caller (This.Tasks);
   end End_Task;

end URVOS.Task_Managements;
