--  SPDX-License-Identifier: Apache-2.0

package body Cortex_SysTick.Timers with SPARK_Mode is

   Stopped : constant Control :=
     (Interrupts | On_Main_Clock => True, others => False);

   Running : constant Control :=
     (Counts | Interrupts | On_Main_Clock => True, others => False);

   --  The count is set to 0 while the timer is off: else a period could end
   --  between the two writes.
   procedure Start (Cycles : Cycle_Count) is
   begin
      Write_Control (Stopped);
      Write_Reload (Cycles - 1);
      Clear_Current;
      Write_Control (Running);
   end Start;

   procedure Set_Next (Cycles : Cycle_Count) is
   begin
      Write_Reload (Cycles - 1);
   end Set_Next;

   procedure Stop is
   begin
      Write_Control (Stopped);
   end Stop;

   procedure Resume is
   begin
      Write_Control (Running);
   end Resume;

   procedure Look (Left : out Natural) is
   begin
      Read_Current (Left);
   end Look;

   procedure Take_Period (Is_Due : out Boolean) is
      Now : Control;
   begin
      Read_Control (Now);
      Is_Due := Now.Has_Ended;
   end Take_Period;

end Cortex_SysTick.Timers;
