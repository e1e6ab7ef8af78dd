--  SPDX-License-Identifier: Apache-2.0

package body Thermostat with SPARK_Mode is

   procedure Report_Not_Claimed (Caller, Holder : Claimant) is
   begin
      Log.Report
        (Semaphore_Not_Claimed, Word (Holder) * 256 + Word (Caller));
   end Report_Not_Claimed;

   procedure Report_Not_Owned (Caller : Claimant; Holder : Task_Id) is
   begin
      Log.Report (Semaphore_Not_Owned, Word (Holder) * 256 + Word (Caller));
   end Report_Not_Owned;

   --  The sensor: a reading each frame. The room warms up and cools down.
   procedure Measure is
      Is_On          : constant Boolean     := Heater_Is_On.Contents;
      Before         : constant Temperature := Room.Contents;
      Now_Is         : constant Temperature :=
        (if Is_On then Temperature'Min (Before, 49_90) + 4
         else Temperature'Max (Before, 1) - 1);
      Unused_Success : Boolean;
   begin
      Room.Write (Now_Is);
      Reading.Send (Now_Is, Unused_Success);
   end Measure;

   --  A guest: takes the switch in his hand, lets it go 12 ticks later,
   --  comes again after a second, and leaves for good in the fourth.
   procedure Fiddle (Now : Clock_Tick; Call : out Kernel_Call) is
      Me             : constant Claimant := Tasks.Id_Of (Guest);
      Present        : constant Semaphore := Switch.Snapshot;
      Unused_Holder  : Task_Id;
      Unused_Success : Boolean;
   begin
      if Owner (Present) /= Me then
         Switch.Try_Claim (Me, Unused_Success, Unused_Holder);
         Call := (Sleep_Call, Next_Frame (Now) + 2, others => <>);
      else
         Switch_Calls.Release (Me, Unused_Success);
         Call :=
           (if Now > 1500 then (Name => Terminate_Call, others => <>)
            else (Sleep_Call, Next_Frame (Now) + 500, others => <>));
      end if;
   end Fiddle;

   --  The control waits for a reading, up to 3 ticks, then for the switch,
   --  as long as a P does. Each look is a step and ends with EXIT.
   procedure Regulate (Now : Clock_Tick; Call : in out Kernel_Call) is
      Me             : constant Claimant := Tasks.Id_Of (Control);
      State          : Progress := Control_State.Contents;
      Look_Again     : Boolean;
      Unused_Success : Boolean;
   begin
      if State.Doing = At_Rest then
         State.Doing := Receiving;
         State.Timeout := Begun (Now, 3);
      end if;

      if State.Doing = Receiving then
         Reading_Calls.Receive_Step
           (Now, State.Timeout, State.Newest, Unused_Success, Look_Again);
         if not Look_Again then
            State.Doing := Claiming;
            State.Timeout := Begun (Now, Switch_Calls.Claim_Wait);
         end if;
      else
         Switch_Calls.Claim_Step
           (Me, Now, State.Timeout, Unused_Success, Look_Again);
         if not Look_Again then
            Heater_Is_On.Write (State.Newest < Wanted);
            Switch_Calls.Release (Me, Unused_Success);
            State.Doing := At_Rest;
         end if;
      end if;

      if State.Doing /= At_Rest then
         Call := (Name => Exit_Call, others => <>);
      end if;
      Control_State.Write (State);
   end Regulate;

   procedure Run_Step
     (Who       : Task_Name;
      First_Run : Boolean;
      Now       : Clock_Tick;
      Call      : out Kernel_Call) is
   begin
      Call :=
        (Next_Frame_Call,
         Offset => Task_List (Who) (Report).Offset,
         others => <>);
      if not First_Run then
         case Who is
            when Sensor  => Measure;
            when Guest   => Fiddle (Now, Call);
            when Control => Regulate (Now, Call);
         end case;
      end if;
   end Run_Step;

   procedure Begin_Again
     (Condition : Start_Condition; Now : Clock_Tick; Passed : out Boolean)
   is
      pragma Unreferenced (Condition);
   begin
      Log.Set_Time (Now);
      Reading.Reset;
      Switch.Reset;
      Control_State.Write ((others => <>));
      Passed := True;
   end Begin_Again;

   procedure Set_Time (Now : Clock_Tick) is
   begin
      Log.Set_Time (Now);
   end Set_Time;

   procedure Report_Overrun (Who : Task_Id) is
   begin
      Log.Report (Task_Overrun, Word (Who));
   end Report_Overrun;

end Thermostat;
