--  SPDX-License-Identifier: Apache-2.0

--  A simulated timer. Before each access come the ends of periods that
--  Simulated_Line plans.

with Simulated_Line;

package body Cortex_SysTick.Registers with SPARK_Mode => Off is

   Present : Timer_Model :=
     (Counts | Interrupts | On_Main_Clock | Has_Ended => False,
      Reload | In_Use                                 => 0,
      Periods | Resets                                => 0);

   procedure Advance;

   procedure Advance is
      Events : Simulated_Line.Event_Count;
   begin
      Simulated_Line.Begin_Access (Events);
      if Present.Counts and then Events > 0 then
         Present.Periods := Present.Periods + Event_Number (Events);
         Present.Has_Ended := True;
         Present.In_Use := Present.Reload;
      end if;
   end Advance;

   function State return Timer_Model is (Present);

   procedure Write_Control (Value : Control) is
   begin
      Advance;
      Present := With_Control (Present, Value);
   end Write_Control;

   procedure Read_Control (Value : out Control) is
   begin
      Advance;
      Value :=
        (Counts        => Present.Counts,
         Interrupts    => Present.Interrupts,
         On_Main_Clock => Present.On_Main_Clock,
         Has_Ended     => Present.Has_Ended);
      if Present.Has_Ended then
         Present.Has_Ended := False;
         Present.Resets := Present.Resets + 1;
      end if;
   end Read_Control;

   procedure Write_Reload (Value : Reload_Value) is
   begin
      Advance;
      Present.Reload := Value;
   end Write_Reload;

   procedure Clear_Current is
   begin
      Advance;
      Present.In_Use := Present.Reload;
      Present.Has_Ended := False;
   end Clear_Current;

   procedure Read_Current (Left : out Natural) is
   begin
      Advance;
      Left := Present.In_Use / 2;
   end Read_Current;

end Cortex_SysTick.Registers;
